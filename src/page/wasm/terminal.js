/*
 * The programs' side of the page's terminal. Where the page has given `Module.terminal`, reading standard input waits
 * for the line that a person types, and what is printed is shown at once, line ended or not. Else the files of
 * emscripten do.
 */
mergeInto(LibraryManager.library, {
  fd_read__sig: 'iiiii',
  fd_read__deps: ['$SYSCALLS', '$Asyncify'],
  fd_read: function (fd, iov, iovcnt, pnum) {
    if (fd !== 0 || !Module['terminal']) {
      try {
        HEAP32[pnum >> 2] = SYSCALLS.doReadv(SYSCALLS.getStreamFromFD(fd), iov, iovcnt);
        return 0;
      } catch (error) {
        return error.errno;
      }
    }
    return Asyncify.handleSleep(function (wakeUp) {
      var room = 0;
      for (var i = 0; i < iovcnt; i++) room += HEAP32[(iov + 8 * i + 4) >> 2];
      Module['terminal'].read(room, function (bytes) {
        var at = 0;
        for (var i = 0; i < iovcnt && at < bytes.length; i++) {
          var part = bytes.subarray(at, at + HEAP32[(iov + 8 * i + 4) >> 2]);
          HEAPU8.set(part, HEAP32[(iov + 8 * i) >> 2]);
          at += part.length;
        }
        HEAP32[pnum >> 2] = at;
        wakeUp(0);
      });
    });
  },
  fd_write__sig: 'iiiii',
  fd_write__deps: ['$SYSCALLS'],
  fd_write: function (fd, iov, iovcnt, pnum) {
    try {
      if ((fd !== 1 && fd !== 2) || !Module['terminal']) {
        HEAP32[pnum >> 2] = SYSCALLS.doWritev(SYSCALLS.getStreamFromFD(fd), iov, iovcnt);
        return 0;
      }
      var written = 0;
      for (var i = 0; i < iovcnt; i++) {
        var from = HEAP32[(iov + 8 * i) >> 2];
        var length = HEAP32[(iov + 8 * i + 4) >> 2];
        Module['terminal'].write(HEAPU8.slice(from, from + length));
        written += length;
      }
      HEAP32[pnum >> 2] = written;
      return 0;
    } catch (error) {
      return error.errno;
    }
  },
});
