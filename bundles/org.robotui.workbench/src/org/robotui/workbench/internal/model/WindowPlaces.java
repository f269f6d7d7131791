package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.Rectangle;

/**
 * Where windows lie on a screen: side by side where each has room enough, else overlapping, each with its title in
 * sight.
 */
public final class WindowPlaces {
  /** Below this the bar at the top of a window would have to be cut, in points. */
  public static final int LEAST_WIDTH = 880;
  private static final int USUAL_WIDTH = 1600;
  private static final int USUAL_HEIGHT = 980;
  /** From one window of a cascade to the next. */
  private static final int STEP = 48;
  /** So much of a window must lie on a screen to be found and moved. */
  private static final int SEEN_WIDTH = 160;
  private static final int SEEN_HEIGHT = 48;

  private WindowPlaces() {}

  /**
   * Places windows.
   *
   * @param screen where there is room
   * @param weights a share of the width for each window, positive
   * @return a place for each
   */
  public static List<Rectangle> of(Rectangle screen, List<Double> weights) {
    List<Rectangle> beside = beside(screen, weights);
    return beside.stream().allMatch(r -> r.width >= LEAST_WIDTH) ? beside : cascade(screen, weights.size());
  }

  /**
   * Places one more window: beside the others where there is room, else with an offset, so that no title is covered
   * exactly.
   *
   * @param screen where there is room
   * @param taken where the others are, at least one
   * @return its place
   */
  public static Rectangle next(Rectangle screen, List<Rectangle> taken) {
    int left = taken.stream().mapToInt(r -> r.x).min().orElse(screen.x) - screen.x;
    int right = screen.x + screen.width - taken.stream().mapToInt(r -> r.x + r.width).max().orElse(screen.x);
    int height = Math.min(USUAL_HEIGHT, screen.height);
    if (right >= LEAST_WIDTH) {
      int width = Math.min(right, USUAL_WIDTH);
      return new Rectangle(screen.x + screen.width - right, screen.y, width, height);
    }
    if (left >= LEAST_WIDTH) {
      int width = Math.min(left, USUAL_WIDTH);
      return new Rectangle(screen.x + left - width, screen.y, width, height);
    }
    return offset(screen, taken);
  }

  private static Rectangle offset(Rectangle screen, List<Rectangle> taken) {
    int most = Math.max(1, Math.min(screen.width, screen.height) / 4 / STEP);
    int at = IntStream.rangeClosed(0, most).map(i -> i * STEP)
        .filter(o -> taken.stream()
            .noneMatch(r -> Math.abs(r.x - screen.x - o) < STEP / 2 && Math.abs(r.y - screen.y - o) < STEP / 2))
        .findFirst().orElse(taken.size() % (most + 1) * STEP);
    return new Rectangle(screen.x + at, screen.y + at, Math.min(USUAL_WIDTH, screen.width - at),
        Math.min(USUAL_HEIGHT, screen.height - at));
  }

  /** Whether a window with these bounds could be found and moved on one of the screens. */
  public static boolean isSeen(Rectangle bounds, List<Rectangle> screens) {
    Rectangle title = new Rectangle(bounds.x, bounds.y, bounds.width, Math.min(bounds.height, SEEN_HEIGHT));
    return screens.stream().map(title::intersection)
        .anyMatch(r -> r.width >= SEEN_WIDTH && r.height >= SEEN_HEIGHT / 2);
  }

  private static List<Rectangle> beside(Rectangle screen, List<Double> weights) {
    double all = weights.stream().mapToDouble(Double::doubleValue).sum();
    List<Rectangle> places = new ArrayList<>();
    double passed = 0;
    for (double weight : weights) {
      int left = (int) Math.round(screen.width * passed / all);
      passed += weight;
      int right = (int) Math.round(screen.width * passed / all);
      places.add(new Rectangle(screen.x + left, screen.y, right - left, screen.height));
    }
    return places;
  }

  private static List<Rectangle> cascade(Rectangle screen, int count) {
    int most = Math.max(1, Math.min(count - 1, Math.min(screen.width, screen.height) / 4 / STEP));
    int width = Math.min(USUAL_WIDTH, screen.width - most * STEP);
    int height = Math.min(USUAL_HEIGHT, screen.height - most * STEP);
    List<Rectangle> places = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int at = i % (most + 1) * STEP;
      places.add(new Rectangle(screen.x + at, screen.y + at, width, height));
    }
    return places;
  }
}
