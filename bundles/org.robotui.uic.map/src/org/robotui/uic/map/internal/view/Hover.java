package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Point;

/** Where the pointer is, and what is said about that place once it rests. Display thread. */
final class Hover {
  private Optional<Point> pointer = Optional.empty();
  private List<CardLine> lines = List.of();

  Optional<Point> pointer() {
    return pointer;
  }

  List<CardLine> lines() {
    return lines;
  }

  void at(int x, int y) {
    pointer = Optional.of(new Point(x, y));
    lines = List.of();
  }

  void away() {
    pointer = Optional.empty();
    lines = List.of();
  }

  void say(List<CardLine> words) {
    lines = List.copyOf(words);
  }
}
