package org.robotui.testkit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.UicContext;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.StreamPort;
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
  private volatile Optional<Frames> frames = Optional.empty();

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

  @Override
  public <Q, R> Caller<Q, R> caller(CallPort<Q, R> port) {
    return (request, timeout, progress) -> new FailedCall<>("nothing is connected to '" + port.name() + "'");
  }

  @Override
  public BrowseInput browse(BrowsePort port) {
    return List::of;
  }

  @Override
  public Principal principal() {
    return FakeAuthority.YOU;
  }

  @Override
  public RobotClock clock() {
    return ruic.clock();
  }

  @Override
  public Frames frames() {
    return frames.orElseThrow(() -> new IllegalStateException("the test gave no frames"));
  }

  @Override
  public SettingsStore settings() {
    return settings;
  }

  private record FailedCall<R>(String reason) implements Caller.Call<R> {
    @Override
    public CompletionStage<CallOutcome<R>> outcome() {
      return CompletableFuture.completedFuture(new CallOutcome.Failed<>(reason));
    }

    @Override
    public void cancel() {
      // It has ended already.
    }
  }
}
