package org.robotui.entity.image.internal;

import java.io.IOException;
import java.util.Optional;

/** A picture says a size that is not shown. The message is for users. */
final class TooLargeException extends IOException {
  private static final long serialVersionUID = 1L;

  TooLargeException(String message) {
    super(message);
  }

  static void check(int width, int height) throws TooLargeException {
    Optional<String> refusal = Limits.refusal(width, height);
    if (refusal.isPresent()) {
      throw new TooLargeException(refusal.get());
    }
  }
}
