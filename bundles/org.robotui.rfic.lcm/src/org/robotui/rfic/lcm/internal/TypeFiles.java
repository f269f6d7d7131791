package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Looks now and then whether the files of types have changed since they were read. For one thread. */
final class TypeFiles {
  private static final String ENDING = ".lcm";
  private static final long BETWEEN_NANOS = Duration.ofSeconds(1).toNanos();

  private final List<Path> places;
  private Map<Path, String> read = Map.of();
  private Map<Path, String> last = Map.of();
  private long lookedAt;

  TypeFiles(List<Path> places) {
    this.places = List.copyOf(places);
  }

  /** They are going to be read now. */
  void reading(long nowNanos) {
    read = stamps();
    last = read;
    lookedAt = nowNanos;
  }

  /**
   * Whether they are others than those that were read, and nobody is just writing them: two looks, a second apart, find
   * the same.
   */
  boolean changed(long nowNanos) {
    if (nowNanos - lookedAt < BETWEEN_NANOS) {
      return false;
    }
    lookedAt = nowNanos;
    Map<Path, String> before = last;
    last = stamps();
    return last.equals(before) && !last.equals(read);
  }

  private Map<Path, String> stamps() {
    Map<Path, String> stamps = new TreeMap<>();
    places.forEach(place -> put(place, stamps));
    return stamps;
  }

  private static void put(Path place, Map<Path, String> stamps) {
    try (Stream<Path> files = Files.walk(place)) {
      for (Path file : files.filter(each -> each.equals(place) || each.toString().endsWith(ENDING)).toList()) {
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        stamps.put(file, now.isDirectory() ? "folder" : now.size() + " bytes of " + now.lastModifiedTime());
      }
    } catch (IOException | UncheckedIOException e) {
      stamps.put(place, "not there"); // whoever reads it says why
    }
  }
}
