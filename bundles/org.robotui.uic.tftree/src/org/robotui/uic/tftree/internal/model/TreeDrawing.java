package org.robotui.uic.tftree.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.FrameId;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.diagram.Box;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.TextWidths;
import org.robotui.ui.diagram.Wire;
import org.robotui.ui.diagram.Wire.Corner;

/**
 * Draws rows as a tree that grows to the right: each depth is a column, a frame stands at the height of the middle of
 * those that it carries. Linear in the number of rows. Pure.
 */
final class TreeDrawing {
  private static final int ROW = Box.HIGH + 12;
  private static final int BETWEEN_TREES = 14;
  private static final int BETWEEN_COLUMNS = 34;
  private static final int PADDING = 24;
  private static final int DOT = 15;
  private static final int LEAST_WIDTH = 80;
  private static final int MOST_WIDTH = 260;

  private final List<FrameRow> rows;
  private final TextWidths widths;
  private final double[] tops;
  private final Map<FrameId, Integer> index = new HashMap<>();
  private final List<Double> columns = new ArrayList<>();
  private final List<Double> lefts = new ArrayList<>();

  private TreeDrawing(List<FrameRow> rows, TextWidths widths) {
    this.rows = rows;
    this.widths = widths;
    this.tops = new double[rows.size()];
  }

  static Diagram draw(List<FrameRow> rows, TextWidths widths) {
    return new TreeDrawing(rows, widths).draw();
  }

  private Diagram draw() {
    for (int i = 0; i < rows.size(); i++) {
      index.put(rows.get(i).id(), i);
      widen(rows.get(i));
    }
    double left = 0;
    for (double width : columns) {
      lefts.add(left);
      left += width + BETWEEN_COLUMNS;
    }
    double height = place();
    List<Box> boxes = new ArrayList<>(rows.size());
    List<Wire> wires = new ArrayList<>(rows.size());
    for (int i = 0; i < rows.size(); i++) {
      boxes.add(box(i));
      wire(i, wires);
    }
    return new Diagram(boxes, wires, Math.max(0, left - BETWEEN_COLUMNS), height);
  }

  private void widen(FrameRow row) {
    while (columns.size() <= row.depth()) {
      columns.add((double) LEAST_WIDTH);
    }
    double wanted =
        Math.max(widths.title(row.title()) + (row.health() == Health.NONE ? 0 : DOT), widths.note(row.note()))
            + PADDING;
    columns.set(row.depth(), Math.clamp(wanted, columns.get(row.depth()), MOST_WIDTH));
  }

  /**
   * Leaves follow each other; the others, which come before what they carry, are placed backwards. Returns the height
   * of all.
   */
  private double place() {
    double next = 0;
    double[] first = new double[rows.size()];
    double[] last = new double[rows.size()];
    boolean[] carries = new boolean[rows.size()];
    for (int i = 0; i < rows.size(); i++) {
      boolean leaf = i + 1 == rows.size() || rows.get(i + 1).depth() <= rows.get(i).depth();
      next += i > 0 && rows.get(i).depth() == 0 ? BETWEEN_TREES : 0;
      if (leaf) {
        tops[i] = next;
        next += ROW;
      }
    }
    for (int i = rows.size() - 1; i >= 0; i--) {
      if (carries[i]) {
        tops[i] = (first[i] + last[i]) / 2;
      }
      int at = i;
      rows.get(i).link().map(link -> index.get(link.parent())).ifPresent(parent -> {
        first[parent] = tops[at];
        last[parent] = carries[parent] ? last[parent] : tops[at];
        carries[parent] = true;
      });
    }
    return Math.max(0, next - (ROW - Box.HIGH));
  }

  private Box box(int i) {
    FrameRow row = rows.get(i);
    Role role = row.health() == Health.BAD ? Role.BAD
        : row.health() == Health.STALE ? Role.WARNING : row.link().isEmpty() ? Role.ACCENT : Role.LINE;
    return new Box(row.id(), lefts.get(row.depth()), tops[i], columns.get(row.depth()), Box.HIGH, Box.Form.ROUNDED,
        row.title(), row.note(),
        row.health(), role);
  }

  private void wire(int i, List<Wire> wires) {
    FrameRow row = rows.get(i);
    row.link().map(link -> index.get(link.parent())).ifPresent(parent -> {
      double from = lefts.get(rows.get(parent).depth()) + columns.get(rows.get(parent).depth());
      double to = lefts.get(row.depth());
      double middle = to - BETWEEN_COLUMNS / 2.0;
      double start = tops[parent] + Box.HIGH / 2.0;
      double end = tops[i] + Box.HIGH / 2.0;
      List<Corner> corners = Math.abs(start - end) < 0.5 ? List.of(new Corner(from, start), new Corner(to, start))
          : List.of(new Corner(from, start), new Corner(middle, start), new Corner(middle, end), new Corner(to, end));
      wires.add(new Wire(rows.get(parent).id(), row.id(), corners, "", row.isProblem() ? row.health().role() : Role.DIM,
          row.link().get().fixed()));
    });
  }
}
