package org.robotui.rfic.recording.internal.lines;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;

/**
 * The bytes of a log. One that is compressed by gzip is decompressed into a file that is gone from its folder as soon
 * as it is open, so that none is left behind.
 *
 * @param in all of them
 * @param damage where it could be decompressed in part only
 */
record LogBytes(RandomAccessFile in, Optional<RecordingDamage> damage) {
  private static final int STEP = 1 << 20;
  private static final long ROOM_STEP = 64L << 20;
  private static final long LEAST_ROOM = 1L << 30;
  private static final int FIRST = 0x1f;
  private static final int SECOND = 0x8b;

  static LogBytes open(Path file) throws RecordingException {
    try {
      return isPacked(file) ? unpacked(file)
          : new LogBytes(new RandomAccessFile(file.toFile(), "r"), Optional.empty());
    } catch (RecordingException e) {
      throw e;
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
  }

  /** The beginning of a log, decompressed: as much of it as can be. */
  static byte[] head(Path file, int length) throws IOException {
    byte[] head = new byte[length];
    int done = 0;
    try (InputStream bytes = stream(file)) {
      for (int read = 0; read >= 0 && done < length; read = bytes.read(head, done, length - done)) {
        done += read;
      }
    } catch (ZipException | EOFException e) {
      return Arrays.copyOf(head, done);
    }
    return Arrays.copyOf(head, done);
  }

  private static InputStream stream(Path file) throws IOException {
    InputStream bytes = new BufferedInputStream(Files.newInputStream(file), STEP);
    return isPacked(file) ? new GZIPInputStream(bytes, STEP) : bytes;
  }

  private static boolean isPacked(Path file) throws IOException {
    try (InputStream bytes = Files.newInputStream(file)) {
      return bytes.read() == FIRST && bytes.read() == SECOND;
    }
  }

  private static LogBytes unpacked(Path file) throws IOException {
    Path plain = Files.createTempFile("robotui-recording", ".log");
    try {
      Optional<RecordingDamage> damage = unpack(file, plain);
      return new LogBytes(new RandomAccessFile(plain.toFile(), "r"), damage);
    } finally {
      Files.deleteIfExists(plain);
    }
  }

  private static Optional<RecordingDamage> unpack(Path file, Path plain) throws IOException {
    long done = 0;
    long checked = 0;
    byte[] bytes = new byte[STEP];
    try (InputStream in = stream(file); OutputStream out = Files.newOutputStream(plain)) {
      while (true) {
        int read;
        try {
          read = in.read(bytes);
        } catch (ZipException | EOFException e) {
          return Optional.of(new RecordingDamage(done, "what follows cannot be decompressed: " + e.getMessage()));
        }
        if (read < 0) {
          return Optional.empty();
        }
        if (done >= checked && plain.toFile().getUsableSpace() < LEAST_ROOM) {
          throw new RecordingException(file, 0, "it is compressed, and " + plain.getParent()
              + " has no room for all of it; decompress it where there is room (gunzip -k), and open what comes out");
        }
        checked = done >= checked ? done + ROOM_STEP : checked;
        out.write(bytes, 0, read);
        done += read;
      }
    }
  }
}
