package org.robotui.ui.internal;

/** What a method handle throws, of a method that declares nothing. */
final class Unexpected {
  private Unexpected() {}

  static RuntimeException of(Throwable e) {
    return switch (e) {
      case Error error -> throw error;
      case RuntimeException runtime -> runtime;
      default -> new IllegalStateException(e);
    };
  }
}
