package org.robotui.rfic.xbot.internal.task;

import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.robotui.rfic.xbot.internal.follow.FollowLink;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;

/** A control with a plugin whose task a test moves. */
final class ScriptedTasks implements FollowLink {
  private final Queue<String> orders = new ConcurrentLinkedQueue<>();
  private volatile Board.PluginState state = Board.PluginState.RUNNING;
  private volatile String phase = "there";

  void state(Board.PluginState now) {
    state = now;
  }

  void phase(String now) {
    phase = now;
  }

  Queue<String> orders() {
    return orders;
  }

  @Override
  public Answer ask(String words) {
    if (words.startsWith("tasks ")) {
      return new Answer(true, "0 1 2 3 4 5\nhand\thand\tbase\t1\t" + phase + "\t111111\t0.1\t0.5");
    }
    orders.add(words);
    return new Answer(true, "");
  }

  @Override
  public List<String> joints() {
    return SixJoints.NAMES;
  }

  @Override
  public List<Board.Plugin> plugins() {
    return List.of(new Board.Plugin("Arm", "CartesianTasks", 0, 0, state, 0, false, "", "hand is moving"));
  }

  @Override
  public Optional<StateFrame> state() {
    return Optional.of(new StateFrame(1, 0, StateFrame.Hardware.OK,
        SixJoints.NAMES.stream().map(name -> joint(SixJoints.bent().get(name))).toList(), List.of(), List.of()));
  }

  private static StateFrame.Joint joint(double position) {
    return new StateFrame.Joint(position, position, 0, 0, 0, new StateFrame.Reference(0, 0, 0, 0, 0), 1, Double.NaN,
        Double.NaN, 0, 0, 0, 0, StateFrame.Control.COMMANDED);
  }
}
