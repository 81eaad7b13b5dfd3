"""Puts pictures on one sheet, a row for each page.

    python3 contact_sheet.py ROWS.json SHEET.png [--height PIXELS] [--colours N]

ROWS.json is an array of rows, each with a "name" and an array "shots" of pictures, with "file" and "title".
Needs Pillow.
"""

import argparse
import json
import pathlib

from PIL import Image, ImageDraw, ImageFont

GAP = 6
FONT = ImageFont.truetype("DejaVuSans.ttf", 13)
LINE = 20


def thumbnail(shot, height):
    picture = Image.open(shot["file"]).convert("RGB")
    width = round(picture.width * height / picture.height)
    return picture.resize((width, height), Image.Resampling.LANCZOS)


def row_of(row, height):
    """The pictures of a page side by side, with their titles above them."""
    pictures = [thumbnail(shot, height) for shot in row["shots"]]
    width = sum(picture.width + GAP for picture in pictures) + GAP
    whole = Image.new("RGB", (width, height + LINE + GAP), (128, 128, 128))
    draw = ImageDraw.Draw(whole)
    x = GAP
    for picture, shot in zip(pictures, row["shots"]):
        whole.paste(picture, (x, LINE))
        # The name stands above the first one; titles are cut off where the next picture begins.
        title = f"{row['name']}: {shot['title']}" if x == GAP else shot["title"]
        draw.text((x, 2), title, "white", FONT)
        draw.rectangle((x + picture.width, 0, width, LINE - 1), (128, 128, 128))
        x += picture.width + GAP
    return whole


def sheet_of(rows, height):
    strips = [row_of(row, height) for row in rows]
    width = max(strip.width for strip in strips)
    whole = Image.new("RGB", (width, sum(strip.height for strip in strips)), (128, 128, 128))
    y = 0
    for strip in strips:
        whole.paste(strip, (0, y))
        y += strip.height
    return whole


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rows", type=pathlib.Path)
    parser.add_argument("sheet")
    parser.add_argument("--height", type=int, default=260)
    parser.add_argument("--colours", type=int)
    wanted = parser.parse_args()
    sheet = sheet_of(json.loads(wanted.rows.read_text()), wanted.height)
    if wanted.colours:
        sheet = sheet.quantize(wanted.colours, dither=Image.Dither.NONE)
    sheet.save(wanted.sheet, optimize=True)


if __name__ == "__main__":
    main()
