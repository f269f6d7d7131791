package org.robotui.api.config;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Optional;

/**
 * Why a file could not be written, for users: the message of the exception alone is often the name of the file once
 * more.
 */
public final class WriteFailure {
  private static final String FULL = "No space left on device";

  private WriteFailure() {}

  /**
   * The reason.
   *
   * @param e what was thrown while a file was made, written or put in its place
   * @return some words, to be put behind the name of the file and a colon
   */
  public static String reason(IOException e) {
    return switch (e) {
      case NoSuchFileException missing -> "its folder is not there";
      case AccessDeniedException denied -> "permission denied";
      case FileSystemException other when other.getReason() != null -> words(other.getReason());
      default -> Optional.ofNullable(e.getMessage()).map(WriteFailure::words).orElse("an unknown error");
    };
  }

  private static String words(String reason) {
    return reason.contains(FULL) ? "the disk is full" : reason;
  }
}
