package org.robotui.script.internal.engine;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptCallback;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;

/** One call of one of our functions. */
final class CallArguments implements ScriptCall {
  private static final double DAY = 86_400;

  private final ScriptFunction function;
  private final Object[] plain;
  private final Surroundings surroundings;
  private final ScriptRun run;

  CallArguments(ScriptFunction function, Object[] plain, Surroundings surroundings, ScriptRun run) {
    this.function = function;
    this.plain = plain;
    this.surroundings = surroundings;
    this.run = run;
  }

  @Override
  public Optional<Object> argument(int index) {
    return Optional.ofNullable(plain[index]);
  }

  private <T> Optional<T> as(int index, Class<T> type, String noun) throws ScriptFailure {
    if (plain[index] == null) {
      return Optional.empty();
    }
    if (!type.isInstance(plain[index])) {
      throw wrong(index, noun);
    }
    return Optional.of(type.cast(plain[index]));
  }

  private ScriptFailure wrong(int index, String noun) {
    String given = PlainText.of(plain[index]);
    return new ScriptFailure(function.signature() + ": " + function.parameters().get(index).name() + " must be " + noun
        + ", not " + (given.length() > 60 ? given.substring(0, 60) + "\u2026" : given));
  }

  @Override
  public String text(int index) throws ScriptFailure {
    return textIf(index).orElseThrow(() -> wrong(index, "a text"));
  }

  @Override
  public Optional<String> textIf(int index) throws ScriptFailure {
    return as(index, String.class, "a text");
  }

  @Override
  public double number(int index) throws ScriptFailure {
    return finite(index).orElseThrow(() -> wrong(index, "a number"));
  }

  @Override
  public double number(int index, double otherwise) throws ScriptFailure {
    return finite(index).orElse(otherwise);
  }

  private Optional<Double> finite(int index) throws ScriptFailure {
    Optional<Double> number = as(index, Number.class, "a number").map(Number::doubleValue);
    if (number.filter(n -> !Double.isFinite(n)).isPresent()) {
      throw wrong(index, "a finite number");
    }
    return number;
  }

  @Override
  public Duration seconds(int index, double otherwise) throws ScriptFailure {
    double seconds = number(index, otherwise);
    if (seconds < 0 || seconds > DAY) {
      throw wrong(index, "a number of seconds from 0 to " + Math.round(DAY));
    }
    return Duration.ofNanos(Math.round(seconds * 1e9));
  }

  @Override
  @SuppressWarnings("unchecked") // maps of scripts are by name
  public Map<String, Object> fields(int index) throws ScriptFailure {
    return as(index, Map.class, "an object such as {x: 1}").map(m -> (Map<String, Object>) m).orElse(Map.of());
  }

  @Override
  public ScriptCallback function(int index) throws ScriptFailure {
    return as(index, ScriptCallback.class, "a function such as () => true")
        .orElseThrow(() -> wrong(index, "a function such as () => true"));
  }

  @Override
  public Host host() {
    return surroundings.host();
  }

  @Override
  public Principal principal() {
    return surroundings.principal();
  }

  @Override
  public Ruic ruic(Optional<String> name) throws ScriptFailure {
    return surroundings.ruic(name);
  }

  @Override
  public void use(Ruic ruic) {
    surroundings.use(ruic);
  }

  @Override
  public PortAccess access(Ruic ruic) {
    return surroundings.access(ruic);
  }

  @Override
  public void print(String text) {
    surroundings.print(text);
  }

  @Override
  public void pause(Duration time) throws InterruptedException {
    run.check();
    Thread.sleep(time);
    run.waited();
  }
}
