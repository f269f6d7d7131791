package org.robotui.testkit;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * PNG files of eight bits red, green and blue, without filters: as much of the format as pictures of tests need, and no
 * toolkit.
 */
final class Png {
  private static final byte[] MAGIC = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  private static final int HEADER = 0x49484452;
  private static final int DATA = 0x49444154;
  private static final int END = 0x49454e44;
  private static final byte[] RGB_8 = {8, 2, 0, 0, 0};

  private Png() {}

  static void write(Path file, SceneImage image) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(MAGIC);
    chunk(out, HEADER, ByteBuffer.allocate(13).putInt(image.width()).putInt(image.height()).put(RGB_8).array());
    chunk(out, DATA, deflated(rows(image)));
    chunk(out, END, new byte[0]);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.write(file, out.toByteArray());
  }

  private static byte[] rows(SceneImage image) {
    ByteBuffer rows = ByteBuffer.allocate((1 + 3 * image.width()) * image.height());
    for (int i = 0; i < image.rgb().length; i++) {
      if (i % image.width() == 0) {
        rows.put((byte) 0);
      }
      int pixel = image.rgb()[i];
      rows.put((byte) (pixel >> 16)).put((byte) (pixel >> 8)).put((byte) pixel);
    }
    return rows.array();
  }

  private static byte[] deflated(byte[] bytes) {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
    try {
      deflater.setInput(bytes);
      deflater.finish();
      byte[] packed = new byte[bytes.length + 1024];
      return Arrays.copyOf(packed, deflater.deflate(packed));
    } finally {
      deflater.end();
    }
  }

  private static void chunk(ByteArrayOutputStream out, int type, byte[] content) throws IOException {
    ByteBuffer chunk = ByteBuffer.allocate(12 + content.length).putInt(content.length).putInt(type).put(content);
    CRC32 check = new CRC32();
    check.update(chunk.array(), 4, 4 + content.length);
    out.write(chunk.putInt((int) check.getValue()).array());
  }

  static SceneImage read(byte[] file) throws IOException {
    ByteBuffer in = ByteBuffer.wrap(file).position(MAGIC.length);
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    int width = 0;
    int height = 0;
    while (in.remaining() >= 12) {
      byte[] content = new byte[in.getInt()];
      int type = in.getInt();
      in.get(content).getInt();
      if (type == HEADER) {
        width = ByteBuffer.wrap(content).getInt();
        height = ByteBuffer.wrap(content).getInt(4);
        requireRgb(content);
      } else if (type == DATA) {
        packed.write(content);
      }
    }
    return unpacked(width, height, packed.toByteArray());
  }

  private static void requireRgb(byte[] header) throws IOException {
    if (!Arrays.equals(header, 8, 13, RGB_8, 0, RGB_8.length)) {
      throw new IOException("not a PNG as these tests write them");
    }
  }

  private static SceneImage unpacked(int width, int height, byte[] packed) throws IOException {
    byte[] rows = new byte[(1 + 3 * width) * height];
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(packed);
      inflater.inflate(rows);
    } catch (DataFormatException e) {
      throw new IOException("a broken PNG", e);
    } finally {
      inflater.end();
    }
    int[] rgb = new int[width * height];
    for (int i = 0; i < rgb.length; i++) {
      int at = i / width * (1 + 3 * width) + 1 + 3 * (i % width);
      rgb[i] = (rows[at] & 0xff) << 16 | (rows[at + 1] & 0xff) << 8 | rows[at + 2] & 0xff;
    }
    return new SceneImage(width, height, rgb);
  }
}
