package org.robotui.rfic.xbot.internal.follow;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;

/** A control with one plugin, which reports what a test wants; the last report stays. */
final class ScriptedPlugin implements FollowLink {
  private final List<String> orders = new ArrayList<>();
  private final Deque<String> reports = new ArrayDeque<>();
  private String onceStopped = "";
  private String tag = "0";

  void reports(String... heads) {
    reports.clear();
    reports.addAll(List.of(heads));
  }

  void reportsOnceStopped(String head) {
    onceStopped = head;
  }

  /** Without the tags. */
  List<String> orders() {
    return orders;
  }

  @Override
  public Answer ask(String words) {
    if (words.startsWith("command Arm @")) {
      String[] parts = words.substring("command Arm @".length()).split(" ", 2);
      tag = parts[0];
      orders.add(parts[1]);
      if (parts[1].equals("stop") && !onceStopped.isEmpty()) {
        reports(onceStopped);
      }
      return new Answer(true, "");
    }
    String head = reports.size() > 1 ? reports.remove() : reports.element();
    return new Answer(true, head.replace("TAG", tag) + "\nnot that\ngiven up\n0.2 0.25\n0.2 0\n0 0");
  }

  @Override
  public List<String> joints() {
    return List.of("pan", "lift");
  }

  @Override
  public List<Board.Plugin> plugins() {
    return List.of(
        new Board.Plugin("Arm", "JointTrajectory", 0, 0, Board.PluginState.RUNNING, 0, false, "", ""),
        new Board.Plugin("Sine", "Sine", 0, 0, Board.PluginState.RUNNING, 0, false, "", ""));
  }

  @Override
  public Optional<StateFrame> state() {
    return Optional.of(new StateFrame(1, 0, StateFrame.Hardware.OK, List.of(joint(0.1), joint(0.4)), List.of(),
        List.of()));
  }

  private static StateFrame.Joint joint(double position) {
    return new StateFrame.Joint(position, position, 0, 0, 0, new StateFrame.Reference(0, 0, 0, 0, 0), 1, Double.NaN,
        Double.NaN, 0, 0, 0, 0, StateFrame.Control.COMMANDED);
  }
}
