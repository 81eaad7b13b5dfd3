// The files of the machine, under the names that they have there, as a file system of the module: for the command
// in node. `node` is its module `fs`.

// Errors of node have the names that those of the module have numbers for.
const numbers = {
  EPERM: 63, ENOENT: 44, EIO: 29, EACCES: 2, EBUSY: 10, EEXIST: 20, ENOTDIR: 54, EISDIR: 31, EINVAL: 28,
  EMFILE: 33, ENOSPC: 51, EROFS: 69, ENOTEMPTY: 55, ENAMETOOLONG: 37, EXDEV: 75, ELOOP: 32,
};

// Does something with files of the machine; what fails is an error of the module.
export const attemptIn = FS => action => {
  try {
    return action();
  } catch (error) {
    if (!error.code)
      throw error;
    throw new FS.ErrnoError(numbers[error.code] ?? 29);
  }
};

// `nameOf` makes the name that the module has for a file of one of the machine. A folder that is mounted with
// `areOpenFiles` has the open files of the process: links, but to no names.
export function hostFiles(FS, node, nameOf) {
  const attempt = attemptIn(FS);

  // Where a file of the module is on the machine.
  function pathOf(entry) {
    const names = [];
    for (; entry.parent !== entry; entry = entry.parent)
      names.unshift(entry.name);
    return [entry.mount.opts.root.replace(/\/$/, ''), ...names].join('/') || '/';
  }

  // What is no file, folder or link is a stream of bytes: pipes are devices of the module, which has no others that
  // can be emptied, as they are before they are written.
  const modeOf = mode => FS.isFile(mode) || FS.isDir(mode) || FS.isLink(mode) ? mode : mode & 0o7777 | 0o020000;

  // Of a file, or of a link itself.
  function statOf(path, follows) {
    const stat = attempt(() => node[follows ? 'statSync' : 'lstatSync'](path));
    stat.mode = modeOf(stat.mode);
    return stat;
  }

  function entryAt(parent, name, mode) {
    const entry = FS.createNode(parent, name, mode, 0);
    entry.node_ops = ofEntries;
    entry.stream_ops = ofStreams;
    return entry;
  }

  const ofEntries = {
    getattr: entry => statOf(pathOf(entry), FS.isRoot(entry) || entry.mount.opts.areOpenFiles),
    readlink: entry => attempt(() => nameOf(node.readlinkSync(pathOf(entry)))),
    setattr(entry, { mode, size, timestamp }) {
      attempt(() => {
        if (mode !== undefined) {
          node.chmodSync(pathOf(entry), mode & 0o7777);
          entry.mode = mode;
        }
        if (size !== undefined)
          node.truncateSync(pathOf(entry), size);
        if (timestamp !== undefined)
          node.utimesSync(pathOf(entry), timestamp / 1000, timestamp / 1000);
      });
    },
    lookup: (parent, name) =>
      entryAt(parent, name, statOf(`${pathOf(parent)}/${name}`, parent.mount.opts.areOpenFiles).mode),
    mknod(parent, name, mode) {
      const entry = entryAt(parent, name, mode), path = pathOf(entry);
      attempt(() => FS.isDir(mode) ? node.mkdirSync(path, mode & 0o7777)
        : node.closeSync(node.openSync(path, 'wx', mode & 0o7777)));
      return entry;
    },
    rename(entry, parent, name) {
      attempt(() => node.renameSync(pathOf(entry), `${pathOf(parent)}/${name}`));
      entry.name = name;
    },
    unlink: (parent, name) => attempt(() => node.unlinkSync(`${pathOf(parent)}/${name}`)),
    rmdir: (parent, name) => attempt(() => node.rmdirSync(`${pathOf(parent)}/${name}`)),
    readdir: entry => ['.', '..', ...attempt(() => node.readdirSync(pathOf(entry)))],
  };

  // The module makes a file, and empties it, before it is opened: what is left of the flags is who may do what,
  // and whether all is written to its end.
  const modes = ['r', 'r+', 'r+'], append = 0o2000;
  const ways = ['r', 'w', 'r+']; // of a pipe: who writes waits for who reads

  const placeIn = (stream, position) => stream.seekable && !(stream.flags & append) ? position : null;

  const ofStreams = {
    open(stream) {
      if (FS.isDir(stream.node.mode))
        return;
      stream.seekable = FS.isFile(stream.node.mode);
      const mode = stream.flags & append ? 'a' : stream.seekable ? modes[stream.flags & 3] : ways[stream.flags & 3];
      stream.file = attempt(() => node.openSync(pathOf(stream.node), mode));
    },
    close(stream) {
      if (stream.file !== undefined)
        attempt(() => node.closeSync(stream.file));
    },
    read: (stream, heap, offset, length, position) =>
      length === 0 ? 0 : attempt(() => node.readSync(stream.file, heap, offset, length, stream.seekable ? position : null)),
    write: (stream, heap, offset, length, position) =>
      attempt(() => node.writeSync(stream.file, heap, offset, length, placeIn(stream, position))),
    llseek(stream, offset, whence) {
      const from = [0, stream.position, attempt(() => node.fstatSync(stream.file ?? 0)).size][whence];
      if (from + offset < 0)
        throw new FS.ErrnoError(numbers.EINVAL);
      return from + offset;
    },
  };

  return {
    mount({ opts }) {
      const root = FS.createNode(null, '/', attempt(() => node.statSync(opts.root)).mode, 0);
      root.node_ops = ofEntries;
      root.stream_ops = ofStreams;
      return root;
    },
  };
}
