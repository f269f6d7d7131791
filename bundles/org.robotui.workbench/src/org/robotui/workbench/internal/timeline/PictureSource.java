package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import org.eclipse.swt.graphics.ImageData;

/** A view of which pictures are taken. Any thread but that of the display. */
public interface PictureSource {
  /**
   * How often the view has taken what is new.
   *
   * @return a number that only rises while it runs
   */
  long ticks();

  /**
   * Has the view show what it has, and takes its picture.
   *
   * @return its pixels
   * @throws IOException where it is shown no more; with a sentence for users
   */
  ImageData picture() throws IOException;
}
