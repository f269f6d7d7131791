package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.alert.AlertSource;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.frame.Frames;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Input;
import org.robotui.api.port.StreamPort;
import org.robotui.api.time.PointedTime;
import org.robotui.api.time.RobotClock;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.data.Data;

/** One running instance of a view with all that it was given. */
final class UicInstance extends Instance implements UicContext {
  private static final Duration GRACE = Duration.ofMillis(200);

  private final ComponentConfig config;
  private final UicType type;
  private final RuicParts ruic;
  private final Principal principal;
  private final UicEnds ends;
  private final UicSettings settings;
  private final Background background;
  private final Background answers;
  private final AlertSource alerts;
  private final Optional<Object> retained;
  private Optional<Ticker> ticker = Optional.empty();
  private volatile Optional<Uic> uic = Optional.empty();

  UicInstance(ComponentConfig config, UicType type, Settings written, Supplier<Authority> fallback, RuicParts ruic,
      Optional<Object> retained) {
    super(config, ruic);
    this.config = config;
    this.type = type;
    this.ruic = ruic;
    this.retained = retained;
    this.principal = ruic.services().stage().get().principal();
    this.background = tasks();
    this.answers = tasks();
    this.ends = new UicEnds(type.ports(), ruic.services(), principal, fallback, answers);
    this.alerts = ruic.alerts().source(config.id());
    this.settings = new UicSettings(written, ruic.overlay().settings(config.id()), ruic.services().check(),
        (key, value) -> ruic.overlay().set(config.id(), key, value));
  }

  /** Creates the instance and gives it its ticker, at rest. */
  @Override
  void start() throws Guarded.GuardException, InterruptedException {
    Services services = ruic.services();
    Uic made = Guarded.call("create", tracked(), Limits.FIRST, () -> type.create(this, settings.current()));
    Ticker ticks = new Ticker(made, type.rateHz(), tracked(),
        () -> services.events().frameReady(ruic.config().name(), config.id()),
        new Ended(), services.clock());
    uic = Optional.of(made);
    ticker = Optional.of(ticks);
    services.watch().add(ticks);
    ticks.start();
    select(false);
  }

  private final class Ended implements Ticker.End {
    @Override
    public void threw(String reason) {
      failed(reason);
    }

    @Override
    public void late(Duration limit) {
      ruic.wake().late(UicInstance.this, limit);
    }
  }

  /** Whether the thread of its ticks has not ended. */
  boolean isTicking() {
    return ticker.filter(Ticker::isAlive).isPresent();
  }

  /** How many ticks it has done. */
  long ticks() {
    return ticker.map(Ticker::done).orElse(0L);
  }

  /** What its successor can go on with; nothing while a thread of its own may still change it. */
  Optional<Object> retain() {
    return isTicking() ? Optional.empty() : uic.flatMap(Uic::retain);
  }

  /** What has no surface, such as an alert, works whether its RUIC is seen or not. */
  void select(boolean selected) {
    ticker.ifPresent(t -> t.select(selected || type.surface() == Surface.NONE));
  }

  @Override
  Optional<Uic> made() {
    return uic;
  }

  @Override
  UicType type() {
    return type;
  }

  UicEnds ends() {
    return ends;
  }

  @Override
  Optional<String> end(Duration limit) throws InterruptedException {
    ticker.ifPresent(t -> ruic.services().watch().remove(t));
    ticker.ifPresent(Ticker::close);
    ends.close();
    background.close();
    answers.close();
    boolean idle = ticker.isEmpty() || ticker.get().awaitEnd(limit.toMillis() / 2);
    Optional<String> problem = idle ? closeInstance(limit.dividedBy(2)) : Optional.of("hangs in tick");
    ruic.alerts().forget(config.id());
    String left = tracked().endAll(GRACE);
    return problem.isPresent() || !left.isEmpty() ? Optional.of(left(problem.orElse("has ended") + left))
        : Optional.empty();
  }

  private Optional<String> closeInstance(Duration limit) throws InterruptedException {
    try {
      if (uic.isPresent()) {
        Guarded.run("close", tracked(), limit, uic.get()::close);
      }
      return Optional.empty();
    } catch (Guarded.GuardException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  public RuicView ruic() {
    return ruic.view();
  }

  @Override
  @SuppressWarnings("unchecked") // the port asked for equals the declared one
  public <T extends Data> Input<T> input(StreamPort<T> port) {
    return (Input<T>) ends.input(port);
  }

  @Override
  @SuppressWarnings("unchecked") // the port asked for equals the declared one
  public <T extends Data> Output<T> output(CommandPort<T> port) {
    return (Output<T>) ends.output(port);
  }

  @Override
  @SuppressWarnings("unchecked") // the port asked for equals the declared one
  public <Q, R> Caller<Q, R> caller(CallPort<Q, R> port) {
    return (Caller<Q, R>) ends.caller(port);
  }

  @Override
  public BrowseInput browse(BrowsePort port) {
    return ends.browser(port);
  }

  @Override
  public Principal principal() {
    return principal;
  }

  @Override
  public RobotClock clock() {
    return ruic.clock();
  }

  @Override
  public PointedTime pointed() {
    return ruic.services().pointed();
  }

  @Override
  public Frames frames() {
    return ruic.frames();
  }

  @Override
  public List<RuicView> ruics() {
    return ruic.services().ruics().get();
  }

  @Override
  public void show(String wanted) {
    ruic.services().events().showWanted(ruic.config().name(), wanted);
  }

  @Override
  public Executor background() {
    return background;
  }

  @Override
  public void alert(String message) {
    ruic.services().events().alert(ruic.config().name(), message);
  }

  @Override
  public AlertSource alerts() {
    return alerts;
  }

  @Override
  public SettingsStore settings() {
    return settings;
  }

  @Override
  public <T> Optional<T> retained(Class<T> type) {
    return retained.filter(type::isInstance).map(type::cast);
  }
}
