package org.robotui.testkit.host;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Layout;

/**
 * An arrangement that holds whatever it is given, for as long as the test runs. Every view that was ever laid out is
 * one of the configuration. Safe for all threads.
 */
public final class FakeArranging implements Arranging {
  private final Map<String, Perspective> perspectives = new TreeMap<>();
  private final Map<String, String> views = new LinkedHashMap<>();
  private final List<Arrangement> asked = new CopyOnWriteArrayList<>();
  private Arrangement written = new Arrangement(new Layout.View("none"));
  private Arrangement now = written;
  private List<ViewFit> types = List.of();
  private Optional<String> perspective = Optional.empty();

  /** One view, {@code none}. */
  public FakeArranging() {
    // As laid out above.
  }

  /**
   * Sets what the configuration says.
   *
   * @param layout of the main window
   */
  public synchronized void write(Layout layout) {
    written = new Arrangement(layout);
    now = written;
    layout.views().forEach(id -> views.put(id, id));
  }

  /**
   * Sets which types of views there are.
   *
   * @param fits each with how it fits
   */
  public synchronized void offer(ViewFit... fits) {
    types = List.of(fits);
  }

  /**
   * What it was asked to arrange, in order.
   *
   * @return the arrangements
   */
  public List<Arrangement> asked() {
    return List.copyOf(asked);
  }

  @Override
  public synchronized Arrangement now() {
    return now;
  }

  @Override
  public synchronized Arrangement written() {
    return written;
  }

  @Override
  public synchronized void arrange(Arrangement wanted) {
    asked.add(wanted);
    now = wanted;
    wanted.added().forEach(view -> views.put(view.id(), view.type()));
  }

  @Override
  public synchronized void reset() {
    now = written;
  }

  @Override
  public synchronized List<ViewChoice> views() {
    List<String> open = now.views();
    return views.entrySet().stream()
        .map(e -> new ViewChoice(e.getKey(), e.getValue(), e.getKey(), open.contains(e.getKey()))).toList();
  }

  @Override
  public synchronized List<ViewFit> types() {
    return types;
  }

  @Override
  public synchronized String freshId(String type) {
    return IntStream.iterate(1, n -> n + 1).mapToObj(n -> n == 1 ? type : type + "-" + n)
        .filter(id -> !views.containsKey(id)).findFirst().orElseThrow();
  }

  @Override
  public synchronized Map<String, Perspective> perspectives() {
    return new TreeMap<>(perspectives);
  }

  @Override
  public synchronized Optional<String> perspective() {
    return perspective;
  }

  @Override
  public synchronized void keep(String name) {
    perspectives.put(name, new Perspective(now, false));
    perspective = Optional.of(name);
  }

  @Override
  public synchronized void choose(String name) {
    Optional.ofNullable(perspectives.get(name)).ifPresent(p -> {
      now = p.arrangement();
      perspective = Optional.of(name);
    });
  }

  @Override
  public synchronized void rename(String name, String next) {
    Optional.ofNullable(perspectives.remove(name)).ifPresent(p -> perspectives.put(next, p));
    perspective = perspective.map(n -> n.equals(name) ? next : n);
  }

  @Override
  public synchronized void forget(String name) {
    perspectives.remove(name);
    perspective = perspective.filter(n -> !n.equals(name));
  }

  @Override
  public Optional<String> export(String name) {
    return Optional.ofNullable(perspectives().get(name)).map(p -> "robotui_perspective: 1\nname: " + name + "\n");
  }

  @Override
  public PerspectiveImport take(String text) {
    return new PerspectiveImport.Refused("a fake takes none");
  }
}
