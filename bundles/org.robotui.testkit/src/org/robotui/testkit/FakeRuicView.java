package org.robotui.testkit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.host.RuicView;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Subject;

/** A RUIC whose snapshot a test sets. */
public final class FakeRuicView implements RuicView {
  /**
   * A connection that was asked for.
   *
   * @param port the view's port
   * @param peer the chosen peer
   */
  public record Connect(SourceId port, SourceId peer) {}

  private final FakeAuthority authority;
  private final FakeAlerts alerts = new FakeAlerts();
  private final FakeSelection selection = new FakeSelection();
  private final FakeShowings showings = new FakeShowings();
  private Map<String, FakeAuthority> team = Map.of();
  private final FakeClock clock = new FakeClock();
  private final List<Connect> connects = new ArrayList<>();
  private RuicSnapshot snapshot;

  /**
   * A selected RUIC with nothing in it.
   *
   * @param authority over its robot, whose name it takes
   */
  public FakeRuicView(FakeAuthority authority) {
    this.authority = authority;
    this.snapshot = new RuicSnapshot(authority.robot(), RuicState.SELECTED, "",
        new LinkState.Connected("localhost:11311"), List.of(), List.of(), List.of());
  }

  /**
   * Sets how it is doing.
   *
   * @param next the snapshot from now on
   */
  public synchronized void snapshot(RuicSnapshot next) {
    snapshot = next;
  }

  /**
   * What was asked to be connected.
   *
   * @return in order
   */
  public synchronized List<Connect> connects() {
    return List.copyOf(connects);
  }

  @Override
  public String name() {
    return authority.robot();
  }

  @Override
  public synchronized RuicSnapshot snapshot() {
    return snapshot;
  }

  /**
   * Gives it robots, each with an interface, in place of the one.
   *
   * @param all who commands each, by the id of its interface
   */
  public synchronized void team(Map<String, FakeAuthority> all) {
    team = new LinkedHashMap<>(all);
  }

  @Override
  public synchronized List<Authority> authorities() {
    return team.isEmpty() ? List.of(authority) : List.copyOf(team.values());
  }

  @Override
  public synchronized Optional<Authority> authority(String component) {
    return team.isEmpty() ? Optional.of(authority) : Optional.ofNullable(team.get(component));
  }

  @Override
  public FakeSelection selection() {
    return selection;
  }

  @Override
  public FakeAlerts alerts() {
    return alerts;
  }

  @Override
  public FakeClock clock() {
    return clock;
  }

  /** The clock jumps back by that. */
  @Override
  public void reset() {
    clock.jump();
  }

  /**
   * The views that show what a user points at.
   *
   * @return always the same
   */
  public FakeShowings showings() {
    return showings;
  }

  @Override
  public List<ShowChoice> showChoices(Subject subject) {
    return showings.choices(subject);
  }

  @Override
  public void show(ShowChoice choice, Subject subject) {
    showings.show(choice, subject);
  }

  @Override
  public Optional<Envelope<?>> newest(SourceId port) {
    return showings.newest(port);
  }

  @Override
  public synchronized void connect(SourceId port, SourceId peer) {
    connects.add(new Connect(port, peer));
  }
}
