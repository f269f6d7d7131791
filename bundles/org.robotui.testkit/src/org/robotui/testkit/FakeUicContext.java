package org.robotui.testkit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import org.robotui.api.UicContext;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.frame.Frames;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.StreamPort;
import org.robotui.api.time.PointedTime;
import org.robotui.api.time.RobotClock;
import org.robotui.data.Data;

/** What core gives to a view, held in a test's hands. Inputs and outputs come into being when they are asked for. */
public final class FakeUicContext implements UicContext {
  private final String instance;
  private final FakeAuthority authority;
  private final FakeRuicView ruic;
  private final FakeSettings settings;
  private final Map<String, FakeInput<?>> inputs = new ConcurrentHashMap<>();
  private final Map<String, FakeOutput<?>> outputs = new ConcurrentHashMap<>();
  private final List<String> told = new CopyOnWriteArrayList<>();
  private final List<String> shown = new CopyOnWriteArrayList<>();
  private final Map<String, Caller<?, ?>> callers = new ConcurrentHashMap<>();
  private volatile List<BrowseInput.Robot> robots = List.of();
  private volatile List<RuicView> ruics;
  private volatile Executor background = Runnable::run;
  private volatile Optional<Frames> frames = Optional.empty();
  private volatile PointedTime pointed = new PointedTime();

  /**
   * A context of one view on a robot named Keira.
   *
   * @param instance the id of the view
   * @param schema of the view's type; the settings begin with its fallbacks
   */
  public FakeUicContext(String instance, Schema schema) {
    this.instance = instance;
    this.authority = new FakeAuthority("Keira");
    this.ruic = new FakeRuicView(authority);
    this.ruics = List.of(ruic);
    this.settings = new FakeSettings(schema);
  }

  /**
   * Gives frames; without, asking for them is an error.
   *
   * @param given the frames
   */
  public void frames(Frames given) {
    frames = Optional.of(given);
  }

  /**
   * The authority over the one robot.
   *
   * @return lease and stop
   */
  public FakeAuthority authority() {
    return authority;
  }

  @Override
  public String instance() {
    return instance;
  }

  @Override
  public FakeRuicView ruic() {
    return ruic;
  }

  @Override
  @SuppressWarnings("unchecked") // one port name has one type, as in a real component
  public <T extends Data> FakeInput<T> input(StreamPort<T> port) {
    return (FakeInput<T>) inputs.computeIfAbsent(port.name(), name -> new FakeInput<T>());
  }

  @Override
  @SuppressWarnings("unchecked") // one port name has one type, as in a real component
  public <T extends Data> FakeOutput<T> output(CommandPort<T> port) {
    return (FakeOutput<T>) outputs.computeIfAbsent(port.name(), name -> new FakeOutput<T>(authority));
  }

  /**
   * Connects a call port.
   *
   * @param <Q> the type of requests
   * @param <R> the type of replies
   * @param port the port
   * @param answers answers the calls
   */
  public <Q, R> void caller(CallPort<Q, R> port, Caller<Q, R> answers) {
    callers.put(port.name(), answers);
  }

  @Override
  @SuppressWarnings("unchecked") // one port name has one type, as in a real component
  public <Q, R> Caller<Q, R> caller(CallPort<Q, R> port) {
    return (Caller<Q, R>) callers.getOrDefault(port.name(), new FakeCaller<Q, R>());
  }

  /**
   * Sets who can be browsed, on all browse ports.
   *
   * @param now the robots
   */
  public void robots(List<BrowseInput.Robot> now) {
    robots = List.copyOf(now);
  }

  @Override
  public BrowseInput browse(BrowsePort port) {
    return () -> robots;
  }

  /**
   * Sets the RUICs of the workbench; without, there is that of this view alone.
   *
   * @param all the RUICs
   */
  public void ruics(List<RuicView> all) {
    ruics = List.copyOf(all);
  }

  @Override
  public List<RuicView> ruics() {
    return ruics;
  }

  @Override
  public void show(String wanted) {
    shown.add(wanted);
  }

  /**
   * Which RUICs were to be shown.
   *
   * @return their names in order
   */
  public List<String> shown() {
    return List.copyOf(shown);
  }

  /**
   * Sets how background tasks run; without, at once on the thread of the caller.
   *
   * @param executor runs them
   */
  public void background(Executor executor) {
    background = executor;
  }

  @Override
  public Executor background() {
    return task -> background.execute(task);
  }

  @Override
  public Principal principal() {
    return FakeAuthority.YOU;
  }

  @Override
  public RobotClock clock() {
    return ruic.clock();
  }

  /**
   * Shares the time at which the user points with other views; without, the view has one of its own.
   *
   * @param shared by all of them
   */
  public void pointed(PointedTime shared) {
    pointed = shared;
  }

  @Override
  public PointedTime pointed() {
    return pointed;
  }

  @Override
  public Frames frames() {
    return frames.orElseThrow(() -> new IllegalStateException("the test gave no frames"));
  }

  /**
   * What the user was told.
   *
   * @return the sentences in order
   */
  public List<String> told() {
    return List.copyOf(told);
  }

  @Override
  public FakeAlerts alerts() {
    return ruic.alerts();
  }

  @Override
  public void alert(String message) {
    told.add(message);
  }

  @Override
  public SettingsStore settings() {
    return settings;
  }
}
