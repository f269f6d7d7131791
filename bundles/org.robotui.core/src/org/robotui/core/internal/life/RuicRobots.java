package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.command.Authority;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.core.internal.command.Arbiter;
import org.robotui.core.internal.command.Arbiters;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.command.RobotPorts;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.config.model.StopCall;
import org.robotui.core.internal.port.CallTarget;
import org.robotui.core.internal.port.StreamSource;

/** The robots of one RUIC, as arbiters see them. */
final class RuicRobots {
  private static final Duration STOP_CALL_LIMIT = Duration.ofSeconds(5);

  private final Supplier<RuicConfig> config;
  private final Services services;
  private final Components components;
  private volatile Map<String, RobotPorts> robots = Map.of(); // exchanged as a whole, on the worker of the RUIC

  RuicRobots(Supplier<RuicConfig> config, Services services, Components components) {
    this.config = config;
    this.services = services;
    this.components = components;
  }

  /** Has the robots that the configuration names now, and no others. */
  void register() {
    Map<String, RobotPorts> before = robots;
    Map<String, RobotPorts> after = new LinkedHashMap<>();
    config.get().rfics().stream().map(ComponentConfig::robot).distinct()
        .forEach(name -> after.put(name, Optional.ofNullable(before.get(name)).orElseGet(() -> new Robot(name))));
    robots = Collections.unmodifiableMap(after);
    after.entrySet().stream().filter(e -> !before.containsKey(e.getKey()))
        .forEach(e -> services.arbiters().register(e.getKey(), e.getValue()));
    before.entrySet().stream().filter(e -> !after.containsKey(e.getKey()))
        .forEach(e -> services.arbiters().unregister(e.getKey(), e.getValue()));
  }

  void unregister() {
    robots.forEach(services.arbiters()::unregister);
  }

  List<Authority> authorities() {
    Arbiters arbiters = services.arbiters();
    return robots.keySet().stream().<Authority>map(arbiters::of).toList();
  }

  Optional<Authority> authority(String component) {
    return config.get().rfic(component).map(c -> services.arbiters().of(c.robot()));
  }

  /** The authority to show for outputs that lead nowhere. */
  Authority first() {
    return services.arbiters().of(robots.keySet().stream().findFirst().orElse(config.get().name()));
  }

  void recheck() {
    robots.keySet().stream().map(services.arbiters()::of).forEach(Arbiter::recheck);
  }

  private final class Robot implements RobotPorts {
    private final String robot;

    Robot(String robot) {
      this.robot = robot;
    }

    @Override
    public List<CommandTarget<?>> commands() {
      return components.commands(robot);
    }

    @Override
    public List<StreamSource<?>> streams() {
      return components.streams(robot);
    }

    @Override
    public SafetyConfig safety() {
      return config.get().safety(robot);
    }

    @Override
    public void cancelCalls() {
      components.calls(robot).forEach(CallTarget::cancelGuarded);
    }

    @Override
    public void callStop() {
      safety().stopCall().ifPresent(this::call);
    }

    private void call(StopCall stop) {
      find(stop).ifPresentOrElse(
          target -> target.urgentCall(stop.request(), STOP_CALL_LIMIT).outcome().thenAccept(this::tell),
          () -> alert("the stop call of " + robot + " cannot be made: " + stop.port() + " is not offered"));
    }

    @SuppressWarnings("unchecked") // the types are compared
    private Optional<CallTarget<ServiceRequest, ServiceReply>> find(StopCall stop) {
      return components.rfics().stream().flatMap(s -> s.offers().stream())
          .filter(o -> o.id().equals(stop.port()))
          .filter(o -> o instanceof CallTarget<?, ?> c && c.port().request() == ServiceRequest.class)
          .map(o -> (CallTarget<ServiceRequest, ServiceReply>) o).findFirst();
    }

    private void tell(CallOutcome<ServiceReply> outcome) {
      switch (outcome) {
        case CallOutcome.Replied<ServiceReply> r -> {}
        case CallOutcome.Failed<ServiceReply> f -> alert("the stop call of " + robot + " failed: " + f.reason());
        case CallOutcome.TimedOut<ServiceReply> t -> alert("the stop call of " + robot + " was not answered");
        case CallOutcome.Cancelled<ServiceReply> c -> alert("the stop call of " + robot + " was cancelled");
      }
    }

    @Override
    public void changed() {
      services.events().changed(config.get().name());
    }

    @Override
    public void alert(String message) {
      services.events().alert(config.get().name(), message);
    }
  }
}
