package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.api.config.WriteFailure;
import org.robotui.ui.PngFile;

/** Files that are named by their numbers: {@code map-00001.png}, {@code map-00002.png}. */
final class NumberedPictures implements PictureTarget {
  private final Path folder;
  private final String name;
  private int written;

  /** Given a file whose name, without its ending, comes before the numbers. */
  NumberedPictures(Path file) {
    folder = file.toAbsolutePath().getParent();
    name = file.getFileName().toString().replaceFirst("(?i)\\.png$", "");
  }

  @Override
  public void add(ImageData picture) throws IOException {
    Path file = folder.resolve(String.format(Locale.ROOT, "%s-%05d.png", name, written + 1));
    if (Files.exists(file)) {
      throw new IOException(file + " is there already: choose another name");
    }
    try {
      PngFile.write(picture, file);
    } catch (IOException e) {
      throw new IOException(file + " could not be written: " + WriteFailure.reason(e), e);
    }
    written++;
  }

  @Override
  public void finish() {
    // each file is whole
  }

  @Override
  public void close() {
    // nothing is open
  }
}
