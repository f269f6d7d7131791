package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;

/** The bundles of a product, as its installer writes them down: {@code bundles.info}. */
record BundleList(Set<Entry> entries) {
  /** One bundle. */
  record Entry(String name, String version) {}

  BundleList {
    entries = Set.copyOf(entries);
  }

  /** Lines of name, version and more, with commas between. */
  static BundleList read(Path file) throws IOException {
    Set<Entry> entries = new LinkedHashSet<>();
    for (String line : Files.readAllLines(file)) {
      String[] words = line.split(",");
      if (!line.startsWith("#") && words.length > 2) {
        entries.add(new Entry(words[0].strip(), words[1].strip()));
      }
    }
    return new BundleList(entries);
  }

  /** What is in this list, but not in another one. */
  Set<Entry> without(BundleList other) {
    Set<Entry> rest = new LinkedHashSet<>(entries);
    rest.removeAll(other.entries());
    return rest;
  }
}
