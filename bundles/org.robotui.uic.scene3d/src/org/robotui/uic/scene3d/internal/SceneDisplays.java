package org.robotui.uic.scene3d.internal;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.gl.display.DisplayContext;

/** What displays may ask of the scene. */
final class SceneDisplays implements DisplayContext {
  private static final Duration VALID = Duration.ofSeconds(2);

  private final UicContext context;

  SceneDisplays(UicContext context) {
    this.context = context;
  }

  @Override
  public Executor background() {
    return context.background();
  }

  @Override
  public Optional<StreamHistory> history(SourceId source) {
    return context.input(ScenePorts.DATA).history(source);
  }

  @Override
  public void wake() {
    // A scene that is seen ticks thirty times a second, whether anything is new or not.
  }

  @Override
  public CommandOutcome send(Data command) {
    return switch (command) {
      case MarkerFeedback feedback -> send(ScenePorts.MARKERS, feedback);
      case NavigationGoal goal -> send(ScenePorts.GOAL, goal);
      case PoseEstimate pose -> send(ScenePorts.INITIAL_POSE, pose);
      default -> new CommandOutcome.Refused(CommandOutcome.Why.NOT_CONNECTED,
          "scenes have no port for " + command.getClass().getSimpleName());
    };
  }

  /** Takes the lease where nobody has it. */
  private <T extends Data> CommandOutcome send(CommandPort<T> port, T command) {
    Output<T> output = context.output(port);
    if (output.targets().isEmpty()) {
      return new CommandOutcome.Refused(CommandOutcome.Why.NOT_CONNECTED, output.state().explanation());
    }
    if (output.authority().take(context.principal(), false) instanceof LeaseOutcome.HeldBy held) {
      return new CommandOutcome.Refused(CommandOutcome.Why.NO_LEASE,
          held.holder().label() + " controls " + output.authority().robot() + "; take over first");
    }
    return output.send(command, VALID);
  }
}
