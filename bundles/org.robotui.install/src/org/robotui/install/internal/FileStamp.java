package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;

/** Size and time of a file: while they change, somebody writes it. */
record FileStamp(long size, Instant changed) {
  private static final Duration SETTLED = Duration.ofSeconds(2);

  /** That of a file, or of what a link leads to; none where it is not there. */
  static Optional<FileStamp> of(Path file) {
    try {
      BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
      return attributes.isRegularFile()
          ? Optional.of(new FileStamp(attributes.size(), attributes.lastModifiedTime().toInstant()))
          : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Whether it was written long enough ago to be whole. */
  boolean isSettled(Instant now) {
    return Duration.between(changed, now).compareTo(SETTLED) > 0;
  }
}
