package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** The file bundles/LAYERS: lines of a level and its bundles, lowest first. */
record Layers(List<Layer> layers) {

  /** One line: its level as written, and the names or patterns of its bundles. */
  record Layer(String level, List<String> patterns) {
  }

  static Layers read(Path file) {
    return parse(Trees.read(file));
  }

  static Layers parse(String text) {
    return new Layers(text.lines()
        .map(line -> line.replaceAll("#.*", "").strip())
        .filter(line -> !line.isEmpty())
        .map(Layers::layer)
        .toList());
  }

  /** How high a bundle stands, or nothing if no line names it. */
  OptionalInt height(String bundle) {
    return IntStream.range(0, layers.size())
        .filter(i -> layers.get(i).patterns().stream().anyMatch(pattern -> matches(pattern, bundle)))
        .findFirst();
  }

  String level(int height) {
    return layers.get(height).level();
  }

  static boolean matches(String pattern, String name) {
    return pattern.endsWith("*") ? name.startsWith(pattern.substring(0, pattern.length() - 1)) : name.equals(pattern);
  }

  private static Layer layer(String line) {
    String[] words = line.split("\\s+");
    return new Layer(words[0], Arrays.asList(words).subList(1, words.length));
  }
}
