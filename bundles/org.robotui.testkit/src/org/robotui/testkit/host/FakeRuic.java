package org.robotui.testkit.host;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robotui.api.Uic;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Match;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Subject;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.testkit.FakeAlerts;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeSelection;
import org.robotui.testkit.FakeShowings;

/** A RUIC whose state a test sets, and which notes down what is asked of it. Safe for all threads. */
public final class FakeRuic implements Ruic {
  private final String name;
  private final FakeAuthority authority;
  private final FakePortAccess access;
  private final Map<String, Uic> uics = new ConcurrentHashMap<>();
  private final Map<String, SettingsStore> settings = new ConcurrentHashMap<>();
  private final Map<String, String> titles = new ConcurrentHashMap<>();
  private final FakeAlerts alerts = new FakeAlerts();
  private final FakeSelection selection = new FakeSelection();
  private final FakeShowings showings = new FakeShowings();
  private final List<String> calls = new CopyOnWriteArrayList<>();
  private final List<String> windows = new CopyOnWriteArrayList<>();
  private final FakeArranging arranging = new FakeArranging();
  private volatile LinkState link = new LinkState.Connected("test");
  private volatile RuicState state = RuicState.INITIALIZED;
  private volatile String reason = "";
  private volatile List<ComponentStatus> components = List.of();
  private volatile List<PortStatus> ports = List.of();
  private volatile List<Match> matches = List.of();
  private volatile List<InterfaceConfig> interfaces = List.of();
  private volatile Function<InterfaceConfig, FakeExchange> exchanges = wanted -> new FakeExchange();

  /**
   * A RUIC without components.
   *
   * @param name its name, also that of its robot
   */
  public FakeRuic(String name) {
    this.name = name;
    authority = new FakeAuthority(name);
    access = new FakePortAccess(authority);
  }

  /**
   * Makes it one that has not started, and does when it is shown.
   *
   * @return this
   */
  public FakeRuic waiting() {
    return in(RuicState.ADDED, "");
  }

  @Override
  public boolean startsShown() {
    return state == RuicState.ADDED;
  }

  /**
   * Adds a running view.
   *
   * @param id its id and title
   * @param uic the instance
   * @return this
   */
  public FakeRuic view(String id, Uic uic) {
    uics.put(id, uic);
    return component(new ComponentStatus(id, id, ComponentStatus.Kind.UIC, RuicState.SELECTED, "", Optional.empty()));
  }

  /**
   * Gives a view settings.
   *
   * @param id of the view
   * @param store its settings
   * @return this
   */
  public FakeRuic settings(String id, SettingsStore store) {
    settings.put(id, store);
    return this;
  }

  /**
   * Sets the status of a component, in place of an earlier one.
   *
   * @param status with the id of the component
   * @return this
   */
  public synchronized FakeRuic component(ComponentStatus status) {
    components =
        Stream.concat(components.stream().filter(c -> !c.id().equals(status.id())), Stream.of(status)).toList();
    return this;
  }

  /**
   * Takes the instance of a view away, as when it failed.
   *
   * @param id of the view
   * @param why the reason of the failure
   */
  public void fail(String id, String why) {
    uics.remove(id);
    component(new ComponentStatus(id, id, ComponentStatus.Kind.UIC, RuicState.FAILED, why, Optional.empty()));
  }

  /**
   * Gives a view a title.
   *
   * @param id of the view
   * @param title what users call it
   * @return this
   */
  public FakeRuic titled(String id, String title) {
    titles.put(id, title);
    return this;
  }

  /**
   * Sets the layout.
   *
   * @param value the layout
   * @return this
   */
  public FakeRuic laidOut(Layout value) {
    arranging.write(value);
    return this;
  }

  /**
   * Sets the link.
   *
   * @param value the link
   * @return this
   */
  public FakeRuic linked(LinkState value) {
    link = value;
    return this;
  }

  /**
   * Sets the ports.
   *
   * @param values the ports
   * @return this
   */
  public FakeRuic offering(PortStatus... values) {
    ports = List.of(values);
    return this;
  }

  /**
   * Sets the matches.
   *
   * @param values the matches
   * @return this
   */
  public FakeRuic matching(Match... values) {
    matches = List.of(values);
    return this;
  }

  /**
   * Sets state and reason.
   *
   * @param value the state
   * @param why the reason, or empty
   * @return this
   */
  public FakeRuic in(RuicState value, String why) {
    state = value;
    reason = why;
    return this;
  }

  /**
   * Sets its robot interfaces, and what becomes of those that are tried in their place.
   *
   * @param trials makes the trial of what is wanted
   * @param values how they are configured
   * @return this
   */
  public FakeRuic exchanging(Function<InterfaceConfig, FakeExchange> trials, InterfaceConfig... values) {
    exchanges = trials;
    interfaces = List.of(values);
    return this;
  }

  /**
   * What was asked of it, in order, for example {@code restart camera}.
   *
   * @return the calls
   */
  public List<String> calls() {
    return List.copyOf(calls);
  }

  /**
   * The windows in which it is shown.
   *
   * @return their names
   */
  public List<String> windows() {
    return List.copyOf(windows);
  }

  /**
   * Its only authority.
   *
   * @return the authority
   */
  public FakeAuthority authority() {
    return authority;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public RuicSnapshot snapshot() {
    return new RuicSnapshot(name, state, reason, link, components, ports, matches);
  }

  @Override
  public List<Authority> authorities() {
    return List.of(authority);
  }

  @Override
  public Optional<Authority> authority(String component) {
    return authorities().stream().findFirst();
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
  public RobotClock clock() {
    return new FakeClock(new Stamp(0, ClockKind.WALL), ClockKind.WALL, Optional.of(Duration.ofMillis(3)), 0);
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
  public void reset() {
    calls.add("reset");
  }

  @Override
  public void connect(SourceId port, SourceId peer) {
    calls.add("connect " + port + " " + peer);
  }

  @Override
  public FakeArranging arranging() {
    return arranging;
  }

  @Override
  public void select(String window) {
    calls.add("select " + window);
    windows.add(window);
  }

  @Override
  public void unselect(String window) {
    calls.add("unselect " + window);
    windows.remove(window);
  }

  @Override
  public Optional<Uic> uic(String id) {
    return Optional.ofNullable(uics.get(id));
  }

  @Override
  public Optional<SettingsStore> settings(String id) {
    return Optional.ofNullable(settings.get(id));
  }

  @Override
  public long ticks(String id) {
    return System.nanoTime();
  }

  @Override
  public String title(String id) {
    return titles.getOrDefault(id, id);
  }

  @Override
  public void surfaceFailed(String id, String why) {
    calls.add("surfaceFailed " + id);
    fail(id, why);
  }

  /**
   * The ports that programs are given.
   *
   * @return always the same
   */
  public FakePortAccess ports() {
    return access;
  }

  @Override
  public FakePortAccess access(Principal principal) {
    return access.as(principal);
  }

  @Override
  public List<InterfaceConfig> interfaces() {
    return interfaces;
  }

  @Override
  public Optional<InterfaceConfig> written(String id) {
    return Optional.empty();
  }

  @Override
  public FakeExchange exchange(InterfaceConfig wanted) {
    calls.add("exchange " + wanted.id() + " " + wanted.type() + " " + wanted.settings());
    return exchanges.apply(wanted);
  }

  @Override
  public CompletionStage<RuicState> restart() {
    calls.add("restart");
    return CompletableFuture.completedFuture(state);
  }

  @Override
  public void restart(String id) {
    calls.add("restart " + id);
  }

  @Override
  public CompletionStage<RuicState> remove() {
    calls.add("remove");
    return CompletableFuture.completedFuture(RuicState.SHUT_DOWN);
  }
}
