package org.robotui.testkit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;

/**
 * The views of a RUIC that show what a user points at, as a test says: it offers them, and notes what they are asked
 * for. Safe for all threads.
 */
public final class FakeShowings {
  /**
   * What was to be shown.
   *
   * @param choice how
   * @param subject what
   */
  public record Shown(ShowChoice choice, Subject subject) {}

  private final List<ShowChoice> choices = new CopyOnWriteArrayList<>();
  private final List<Shown> shown = new CopyOnWriteArrayList<>();
  private final Map<SourceId, Envelope<?>> newest = new ConcurrentHashMap<>();

  /** Without any view. */
  public FakeShowings() {}

  /**
   * Adds a view that can show something.
   *
   * @param view its id and title
   * @param showing what it does
   * @return this
   */
  public FakeShowings offer(String view, Showing showing) {
    choices.add(new ShowChoice(view, view, showing, ""));
    return this;
  }

  /**
   * Adds a type of view that cannot show anything.
   *
   * @param showing what it would do
   * @param obstacle why not
   * @return this
   */
  public FakeShowings refuse(Showing showing, String obstacle) {
    choices.add(new ShowChoice("", showing.label(), showing, obstacle));
    return this;
  }

  /**
   * Sets the newest value of a stream.
   *
   * @param value from that stream
   */
  public void newest(Envelope<?> value) {
    newest.put(value.source(), value);
  }

  /**
   * What views were asked to show.
   *
   * @return in order
   */
  public List<Shown> shown() {
    return List.copyOf(shown);
  }

  /**
   * As {@link org.robotui.api.host.RuicView#showChoices}.
   *
   * @param subject what the user points at
   * @return what is offered for its kind
   */
  public List<ShowChoice> choices(Subject subject) {
    return choices.stream().filter(choice -> choice.showing().isFor(subject)).toList();
  }

  /**
   * As {@link org.robotui.api.host.RuicView#show}.
   *
   * @param choice how
   * @param subject what
   */
  public void show(ShowChoice choice, Subject subject) {
    shown.add(new Shown(choice, subject));
  }

  /**
   * As {@link org.robotui.api.host.RuicView#newest}.
   *
   * @param port a port of a robot interface
   * @return what was set
   */
  public Optional<Envelope<?>> newest(SourceId port) {
    return Optional.ofNullable(newest.get(port));
  }
}
