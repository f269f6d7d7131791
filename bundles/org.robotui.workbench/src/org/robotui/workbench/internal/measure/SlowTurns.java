package org.robotui.workbench.internal.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The slowest turns of the display thread and what it did meanwhile, as looks at its stack found it: the line of ours
 * that was found most often. Used on one thread, but for {@link #worst}.
 */
final class SlowTurns {
  private static final int MOST = 8;
  private static final int MOST_LOOKS = 200;
  private static final String OURS = "org.robotui.";
  private static final List<String> VIEWS = List.of(OURS + "uic.", OURS + "entity.");

  private final List<Place> looks = new ArrayList<>();
  private volatile List<Turn> worst = List.of();

  /**
   * A turn.
   *
   * @param millis how long a task had to wait
   * @param afterSeconds when it ended, from the begin of the measurement
   * @param view the package of the view that was painted or refreshed, or empty
   * @param at the line that was found most often, or empty where the thread had done before anybody looked
   */
  record Turn(double millis, double afterSeconds, String view, String at) {}

  private record Place(String view, String at) {
    private static final Place NOWHERE = new Place("", "");
  }

  /** Looks at what the display thread does within a turn that goes on. */
  void look(StackTraceElement... stack) {
    if (looks.size() < MOST_LOOKS && stack.length > 0) {
      looks.add(new Place(view(stack), line(stack)));
    }
  }

  /** A turn is over. */
  void over(double millis, double afterSeconds) {
    List<Turn> now = worst;
    if (now.size() < MOST || now.getLast().millis() < millis) {
      Place place = usual();
      List<Turn> more = new ArrayList<>(now);
      more.add(new Turn(millis, afterSeconds, place.view(), place.at()));
      more.sort(Comparator.comparingDouble(Turn::millis).reversed());
      worst = List.copyOf(more.subList(0, Math.min(MOST, more.size())));
    }
    forget();
  }

  /** A turn is over that does not count. */
  void forget() {
    looks.clear();
  }

  /** The slowest, worst first. Any thread. */
  List<Turn> worst() {
    return worst;
  }

  private Place usual() {
    return looks.stream().collect(Collectors.groupingBy(Function.identity(), Collectors.counting())).entrySet().stream()
        .max(Comparator.comparingLong(e -> e.getValue())).map(e -> e.getKey()).orElse(Place.NOWHERE);
  }

  /** The first line of ours below what the platform does for it; where there is none, the first of all. */
  private static String line(StackTraceElement... stack) {
    Optional<StackTraceElement> ours = Arrays.stream(stack).filter(f -> f.getClassName().startsWith(OURS)).findFirst();
    return ours.orElse(stack[0]).toString();
  }

  private static String view(StackTraceElement... stack) {
    return Arrays.stream(stack).map(StackTraceElement::getClassName)
        .filter(name -> VIEWS.stream().anyMatch(name::startsWith)).findFirst()
        .map(name -> String.join(".", Arrays.asList(name.split("\\.")).subList(0, 4))).orElse("");
  }
}
