package org.robotui.ui;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.robotui.api.config.AtomicFile;

/** Pictures as files. The toolkit, where it writes one itself, says no more of a failure than that there was one. */
public final class PngFile {
  private PngFile() {}

  /**
   * Writes a picture. Any thread; may block.
   *
   * @param picture its pixels
   * @param file a PNG file; replaced where it exists
   * @throws IOException where it cannot be written
   */
  public static void write(ImageData picture, Path file) throws IOException {
    ImageLoader loader = new ImageLoader();
    loader.data = new ImageData[]{picture};
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    loader.save(bytes, SWT.IMAGE_PNG);
    AtomicFile.write(file, bytes::writeTo);
  }
}
