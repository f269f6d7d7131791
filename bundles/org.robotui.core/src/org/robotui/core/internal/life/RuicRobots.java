package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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

/** The robots of one RUIC, as arbiters see them. */
final class RuicRobots {
  private static final Duration STOP_CALL_LIMIT = Duration.ofSeconds(5);

  private final RuicConfig config;
  private final Services services;
  private final Components components;
  private final Map<String, RobotPorts> robots = new LinkedHashMap<>();

  RuicRobots(RuicConfig config, Services services, Components components) {
    this.config = config;
    this.services = services;
    this.components = components;
    config.rfics().stream().map(ComponentConfig::robot).distinct().forEach(r -> robots.put(r, new Robot(r)));
  }

  void register() {
    robots.forEach(services.arbiters()::register);
  }

  void unregister() {
    robots.forEach(services.arbiters()::unregister);
  }

  List<Authority> authorities() {
    Arbiters arbiters = services.arbiters();
    return robots.keySet().stream().<Authority>map(arbiters::of).toList();
  }

  Optional<Authority> authority(String component) {
    return config.rfics().stream().filter(c -> c.id().equals(component)).findFirst()
        .map(c -> services.arbiters().of(c.robot()));
  }

  /** The authority to show for outputs that lead nowhere. */
  Authority first() {
    return services.arbiters().of(robots.keySet().stream().findFirst().orElse(config.name()));
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
    public SafetyConfig safety() {
      return config.safety(robot);
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
        case CallOutcome.Replied<ServiceReply> r -> { }
        case CallOutcome.Failed<ServiceReply> f -> alert("the stop call of " + robot + " failed: " + f.reason());
        case CallOutcome.TimedOut<ServiceReply> t -> alert("the stop call of " + robot + " was not answered");
        case CallOutcome.Cancelled<ServiceReply> c -> alert("the stop call of " + robot + " was cancelled");
      }
    }

    @Override
    public void changed() {
      services.events().changed(config.name());
    }

    @Override
    public void alert(String message) {
      services.events().alert(config.name(), message);
    }
  }
}
