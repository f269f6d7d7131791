package org.robotui.uic.body.internal.model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.Input;
import org.robotui.data.status.BodyState;

/**
 * Takes what bodies say, remembers the last {@value #KEPT} states of each, and makes the lines. All but the wish is for
 * the thread that ticks.
 */
public final class BodyModel {
  private static final int KEPT = 600;
  private static final int MOST_MOMENTS = 200;
  private static final double NANOS = 1e9;

  private final Input<BodyState> input;
  private final Map<String, Deque<Seen>> past = new TreeMap<>();
  private volatile BodyWish wish = BodyWish.FIRST;
  private volatile BodyLook look;

  private record Seen(BodyState body, long nanos) {}

  /** Over an input. */
  public BodyModel(Input<BodyState> input) {
    this.input = input;
    this.look = new BodyLook(List.of(), 0, Optional.empty(), input.state(), false);
  }

  public BodyWish wish() {
    return wish;
  }

  public void wish(BodyWish next) {
    wish = next;
  }

  public BodyLook look() {
    return look;
  }

  /** Takes what came; whether there is something new to see. */
  public boolean tick(long nowNanos, double staleSeconds) {
    input.drain(e -> {
      Deque<Seen> all = past.computeIfAbsent(e.source().toString(), source -> new ArrayDeque<>());
      all.addLast(new Seen(e.value(), e.receivedNanos()));
      if (all.size() > KEPT) {
        all.removeFirst();
      }
    });
    BodyWish asked = wish;
    List<BodyLine> lines = new ArrayList<>();
    int parts = 0;
    for (Map.Entry<String, Deque<Seen>> each : past.entrySet()) {
      Seen last = each.getValue().getLast();
      parts += last.body().parts().size();
      lines.addAll(new LineMaker(asked, staleSeconds, Math.max(0, (nowNanos - last.nanos()) / NANOS))
          .lines(each.getKey(), past.size() > 1, last.body()));
    }
    BodyLook next = new BodyLook(lines, parts, asked.selected().flatMap(key -> past(key, lines, nowNanos)),
        input.state(), !asked.search().isBlank());
    boolean changed = !next.equals(look);
    look = next;
    return changed;
  }

  private Optional<BodyPast> past(String key, List<BodyLine> lines, long nowNanos) {
    return lines.stream().filter(line -> line.key().equals(key)).findFirst()
        .flatMap(line -> past.entrySet().stream().filter(each -> key.startsWith(each.getKey() + "/")).findFirst()
            .map(each -> past(line, each.getKey(), each.getValue(), nowNanos)));
  }

  /** Each state is asked for the same line; it is a new moment where it says something else. */
  private static BodyPast past(BodyLine line, String source, Deque<Seen> states, long nowNanos) {
    List<BodyPast.Moment> moments = new ArrayList<>();
    List<BodyPast.Point> curve = new ArrayList<>();
    String said = "";
    for (Seen seen : states) {
      double ago = Math.max(0, (nowNanos - seen.nanos()) / NANOS);
      Optional<BodyLine> then = LineMaker.line(source, seen.body(), line.key());
      if (then.isPresent()) {
        then.get().number().ifPresent(number -> curve.add(new BodyPast.Point(ago, number)));
        if (moments.isEmpty() || !then.get().value().equals(said)) {
          said = then.get().value();
          moments.add(new BodyPast.Moment(ago, said));
        }
      }
    }
    List<BodyPast.Moment> newest = moments.reversed();
    return new BodyPast(line, newest.subList(0, Math.min(MOST_MOMENTS, newest.size())), curve);
  }
}
