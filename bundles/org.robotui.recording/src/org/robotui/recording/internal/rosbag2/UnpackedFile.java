package org.robotui.recording.internal.rosbag2;

import com.github.luben.zstd.ZstdInputStreamNoFinalizer;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.io.FileBytes;

/**
 * A file that is compressed as a whole, which no place can be read in: it is decompressed into a file that is gone from
 * its folder as soon as it is open, so that none is left behind even where the process is killed.
 */
final class UnpackedFile {

  private static final long LEAST_ROOM = 1L << 30;
  private static final long ROOM_STEP = 64L << 20;
  private static final int STEP = 1 << 20;
  private static final int MAGIC = 0xfd2fb528;

  private UnpackedFile() {}

  /** Whether it is compressed so, by its first bytes. */
  static boolean isPacked(FileBytes file) throws RecordingException {
    if (file.size() < Integer.BYTES) {
      return false;
    }
    byte[] head = file.read(0, Integer.BYTES);
    return (head[0] & 0xff | (head[1] & 0xff) << 8 | (head[2] & 0xff) << 16 | (head[3] & 0xff) << 24) == MAGIC;
  }

  /**
   * @param folder where there is room
   * @param damages hears where it could be decompressed in part only
   */
  static FileBytes of(Path packed, Path folder, DamageList damages, ScanProgress progress) throws RecordingException {
    Path plain;
    try {
      plain = Files.createTempFile(folder, "robotui-recording", ".plain");
    } catch (IOException e) {
      throw new RecordingException(packed, "cannot be decompressed into " + folder, e);
    }
    try {
      unpack(packed, plain, damages, progress);
      return FileBytes.open(plain, packed);
    } finally {
      delete(plain);
    }
  }

  private static void unpack(Path packed, Path plain, DamageList damages, ScanProgress progress)
      throws RecordingException {
    try (SeekableByteChannel from = Files.newByteChannel(packed);
        InputStream in = new ZstdInputStreamNoFinalizer(new BufferedInputStream(Channels.newInputStream(from), STEP));
        OutputStream out = Files.newOutputStream(plain)) {
      byte[] bytes = new byte[STEP];
      long done = 0;
      long checked = 0;
      for (int read = read(in, bytes, done, damages); read >= 0; read = read(in, bytes, done, damages)) {
        if (done >= checked && plain.toFile().getUsableSpace() < LEAST_ROOM) {
          throw new RecordingException(packed, 0, "it is compressed, and " + plain.getParent() + " has no room for all"
              + " of it; decompress it where there is room (zstd -d), and open what comes out");
        }
        checked = done >= checked ? done + ROOM_STEP : checked;
        out.write(bytes, 0, read);
        done += read;
        progress.scanned(from.position(), from.size());
      }
    } catch (RecordingException e) {
      throw e;
    } catch (IOException e) {
      throw new RecordingException(packed, "cannot be decompressed", e);
    }
  }

  private static int read(InputStream in, byte[] bytes, long done, DamageList damages) {
    try {
      return in.read(bytes);
    } catch (IOException e) {
      damages.add(done, "what follows cannot be decompressed: " + e.getMessage());
      return -1;
    }
  }

  private static void delete(Path plain) throws RecordingException {
    try {
      Files.deleteIfExists(plain);
    } catch (IOException e) {
      throw new RecordingException(plain, "cannot be taken away again", e);
    }
  }
}
