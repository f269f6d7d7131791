package org.robotui.web.tree;

import java.io.IOException;

/** What a peer sent is no tree, or not the one that was expected. */
public final class TreeException extends IOException {

  private static final long serialVersionUID = 1L;

  /**
   * Creates it.
   *
   * @param message what is wrong, for users
   */
  public TreeException(String message) {
    super(message);
  }
}
