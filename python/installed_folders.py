"""Prints the folders of compiled modules, relative to a prefix, separated by a semicolon: where what comes in
packages of the system is, and where all else is. They differ on Debian."""

import sysconfig


def folder(scheme):
    path = sysconfig.get_path("platlib", scheme, vars={"base": "", "platbase": ""}).lstrip("/")
    return path[len("local/"):] if path.startswith("local/") else path


usual = sysconfig.get_default_scheme() if hasattr(sysconfig, "get_default_scheme") else sysconfig._get_default_scheme()
of_packages = "deb_system" if "deb_system" in sysconfig.get_scheme_names() else usual
print(folder(of_packages), folder(usual), sep=";")
