package org.robotui.sim.internal.camera;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Compresses pictures of one size. For one thread. */
public final class JpegEncoder {
  private static final float QUALITY = 0.85f;

  private final int width;
  private final int height;
  private final BufferedImage image;
  private final ImageWriter writer;
  private final ImageWriteParam parameters;

  public JpegEncoder(int width, int height) {
    this.width = width;
    this.height = height;
    image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    parameters = writer.getDefaultWriteParam();
    parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    parameters.setCompressionQuality(QUALITY);
  }

  /** @param pixels of 0xrrggbb, row by row from the top */
  public byte[] encode(int[] pixels) {
    image.getRaster().setDataElements(0, 0, width, height, pixels);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream(32 * 1024);
    try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(image, null, null), parameters);
    } catch (IOException e) {
      throw new UncheckedIOException("a picture in memory cannot be compressed", e);
    } finally {
      writer.setOutput(null);
    }
    return bytes.toByteArray();
  }
}
