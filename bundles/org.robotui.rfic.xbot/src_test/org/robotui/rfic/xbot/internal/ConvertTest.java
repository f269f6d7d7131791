package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.xbot.Board;
import org.robotui.xbot.Board.PluginState;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.StateFrame;
import org.robotui.xbot.Timing;

class ConvertTest {
  private static final Timing.Buckets NONE = new Timing.Buckets(List.of(0L, 0L), 0);

  private static Board board(PluginState state) {
    return new Board("arm", "dummy", true, 0,
        List.of(new Board.Joint("pan", 1, false, -1, 1, 2, 80), new Board.Joint("lift", 2, true, 0, 0.5, 0.1, 200)),
        List.of(), List.of(), List.of(new Board.Host("main", 17, 3, "")),
        List.of(new Board.Plugin("homing", "Homing", 0, 0, state, 3, false, "", "half way")),
        List.of(new Board.Chain("all", List.of(1, 0, 9))));
  }

  private static StateFrame.Joint joint(double position, int owner) {
    return new StateFrame.Joint(position, position, 0.1, 0.1, 5, new StateFrame.Reference(0.2, 0, 0, 100, 1), 25, 40,
        Double.NaN, 4, 2,
        1, owner, StateFrame.Control.HOLDING);
  }

  private static StateFrame state(StateFrame.Joint... joints) {
    return new StateFrame(7, 1, StateFrame.Hardware.OK, List.of(joints), List.of(), List.of());
  }

  private static Timing thread(String name) {
    return new Timing(name, 1_000_000, 60, 1, 10, 1, 0, 0, 0, NONE, NONE);
  }

  @Test
  void aJointSaysWhoOwnsItAndWhatIsMeant() {
    JointControl.Joint joint =
        Convert.control(board(PluginState.RUNNING), state(joint(0.3, 0), joint(0, -1))).joints().getFirst();
    assertEquals("homing", joint.owner());
    assertEquals(Set.of(JointMode.POSITION, JointMode.STIFFNESS, JointMode.DAMPING), joint.modes());
    assertEquals(JointControl.Source.HOLDING, joint.source());
    assertEquals(0.2, joint.reference().position());
    assertEquals(4, joint.faults());
  }

  @Test
  void nobodyIsNoOwner() {
    assertEquals("", Convert.control(board(PluginState.STOPPED), state(joint(0, -1))).joints().getFirst().owner());
  }

  @Test
  void aStateOfFewerJointsThanTheBoardIsCutToThem() {
    assertEquals(List.of("pan"), Convert.joints(board(PluginState.STOPPED), state(joint(0, -1))).joints().stream()
        .map(j -> j.name()).toList());
  }

  @Test
  void chainsNameTheirJointsAndLeaveOutWhatIsNotThere() {
    JointModel model = Convert.model(board(PluginState.STOPPED));
    assertEquals(List.of(new JointModel.Chain("all", List.of("lift", "pan"))), model.chains());
    assertEquals(JointModel.Type.PRISMATIC, model.joints().get(1).type());
  }

  @Test
  void aPluginIsShownWithWhatItsProcessSays() {
    HostReading host = new HostReading(List.of(thread("rt_main")), Map.of(0, new HostReading.Plugin(42, 900, NONE)));
    ControlPlugins.Plugin plugin = Convert.plugins(board(PluginState.RUNNING), List.of(host)).plugins().getFirst();
    assertEquals("rt_main", plugin.thread());
    assertEquals("main", plugin.process());
    assertEquals(42, plugin.cycles());
    assertEquals(ControlPlugins.State.RUNNING, plugin.state());
    assertEquals("half way", plugin.status());
  }

  @Test
  void aPluginWithoutItsProcessIsShownAsWell() {
    ControlPlugins.Plugin plugin = Convert.plugins(board(PluginState.ABSENT), List.of()).plugins().getFirst();
    assertEquals(ControlPlugins.State.ABSENT, plugin.state());
    assertEquals(0, plugin.cycles());
  }

  @Test
  void memoryThatAPluginOverwroteIsNamed() {
    Board board = board(PluginState.RUNNING);
    assertEquals("", Convert.damage(board, List.of(new HostReading(List.of(), Map.of()))));
    assertEquals("the memory of the host main is damaged (its head is overwritten): its figures are left out",
        Convert.damage(board, List.of(new HostReading(List.of(), Map.of(), "its head is overwritten"))));
  }

  @Test
  void theLoopAtTheHardwareComesFirst() {
    LoopTiming timing = Convert.timing(board(PluginState.RUNNING), thread("HAL"),
        List.of(new HostReading(List.of(thread("rt_main")), Map.of())));
    assertEquals(List.of("HAL", "rt_main"), timing.loops().stream().map(LoopTiming.Loop::name).toList());
    assertEquals("main", timing.loops().get(1).process());
    assertTrue(timing.realTime());
  }

  @Test
  void allStatesOfPluginsHaveTheirLike() {
    for (PluginState state : PluginState.values()) {
      assertEquals(state.name(), Convert.plugins(board(state), List.of()).plugins().getFirst().state().name());
    }
  }
}
