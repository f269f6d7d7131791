package org.robotui.ui.control;

import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.ImageTransfer;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.widgets.Display;

/** Copies to the clipboard of the desktop. Display thread. */
public final class Clipboards {
  private Clipboards() {}

  /**
   * Copies a text.
   *
   * @param text the text; where it is empty the clipboard stays as it is
   */
  public static void copy(String text) {
    if (!text.isEmpty()) {
      copy(text, TextTransfer.getInstance());
    }
  }

  /**
   * Copies a picture.
   *
   * @param picture its pixels
   */
  public static void copy(ImageData picture) {
    copy(picture, ImageTransfer.getInstance());
  }

  private static void copy(Object content, Transfer form) {
    Clipboard clipboard = new Clipboard(Display.getCurrent());
    clipboard.setContents(new Object[]{content}, new Transfer[]{form});
    clipboard.dispose();
  }
}
