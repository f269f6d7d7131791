package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import org.eclipse.swt.graphics.ImageData;

/** Where pictures go, one after the other. For one thread. */
interface PictureTarget extends AutoCloseable {
  /** Adds a picture; fails with a sentence for users. */
  void add(ImageData picture) throws IOException;

  /** There are no more. */
  void finish() throws IOException, InterruptedException;

  @Override
  void close();
}
