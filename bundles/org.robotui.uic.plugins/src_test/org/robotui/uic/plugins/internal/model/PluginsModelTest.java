package org.robotui.uic.plugins.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.data.control.Drives.Phase;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.uic.plugins.internal.Controls;

class PluginsModelTest {
  private static final Duration TIMEOUT = Duration.ofSeconds(3);

  private final FakeUicContext context = new FakeUicContext("plugins", Schema.EMPTY);
  private final FakeInput<ControlPlugins> plugins = new FakeInput<>();
  private final FakeInput<LoopTiming> timing = new FakeInput<>();
  private final FakeInput<Drives> drives = new FakeInput<>();
  private final FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>(Controls.VERBS);
  private final PluginsModel model = new PluginsModel(context, plugins, timing, drives, caller, () -> TIMEOUT);

  @Test
  void pluginsStandBelowTheirThreads() {
    put();
    assertEquals(
        List.of("loop HAL/hal", "loop motion/fast", "plugin homing", "plugin gravity", "plugin sine",
            "loop motion/slow",
            "plugin cartesian", "plugin logging", "loop links/io", "plugin communication"),
        model.look().lines().stream().map(Line::key).toList());
    assertEquals("3 of 6 running \u00b7 1 failed \u00b7 10.0\u00a0Hz", model.look().note());
  }

  @Test
  void drivesStandBelowTheThreadOfTheHardware() {
    put();
    drives.put(Controls.drives(Phase.FAULT, Phase.ENABLED, Phase.DISABLED));
    model.tick(0);
    Line line = model.look().lines().get(1);
    assertEquals("drives", line.key());
    assertEquals("fault", line.word());
    assertEquals(Health.BAD, line.health());
    assertEquals("shoulder: fault, 0x3210 (DC link over-voltage)", line.words());
    assertTrue(model.look().note().contains("drives: fault"), model.look().note());
    PluginDetail detail = PluginDetail.of(model.look(), "drives").orElseThrow();
    assertEquals("1 in fault: shoulder \u00b7 1 disabled: wrist \u00b7 1 enabled", detail.status());
    assertEquals("shoulder: fault, 0x3210 (DC link over-voltage)", detail.problem());
  }

  @Test
  void whatWasAskedOfDrivesIsToldUntilTheyChange() {
    put();
    drives.put(Controls.drives(Phase.ENABLED, Phase.ENABLED, Phase.ENABLED));
    model.tick(0);
    model.verbs().ask(DrivesLine.ALL, Verb.DISABLE_DRIVES, "");
    assertEquals(new PluginRequest("", Verb.DISABLE_DRIVES, ""), caller.made().getLast().request());
    caller.made().getLast().end().complete(new CallOutcome.Replied<>(new PluginReply(false, "homing leads joints")));
    model.tick(0);
    assertEquals("Drives not disabled: homing leads joints",
        PluginDetail.of(model.look(), "drives").orElseThrow().problem());
    drives.put(Controls.drives(Phase.DISABLED, Phase.DISABLED, Phase.DISABLED));
    model.tick(0);
    model.tick(0);
    PluginDetail after = PluginDetail.of(model.look(), "drives").orElseThrow();
    assertEquals("3 disabled", after.status());
    assertEquals("", after.problem());
  }

  @Test
  void hardwareWithoutDrivesHasNoLineOfThem() {
    put();
    drives.put(new Drives(List.of()));
    model.tick(0);
    assertEquals(Optional.empty(), model.look().drives());
  }

  @Test
  void threadsThatAreNotMeasuredAreKnownByTheirPlugins() {
    plugins.put(Controls.arm());
    model.tick(0);
    LoopLine first = (LoopLine) model.look().lines().getFirst();
    assertEquals("motion \u00b7 fast", first.name());
    assertEquals("unmeasured", first.word());
    assertEquals(Health.NONE, first.health());
    assertFalse(model.look().isNotRealTime());
  }

  @Test
  void missingRightsAreTold() {
    plugins.put(Controls.arm());
    timing.put(Controls.timing(false));
    model.tick(0);
    assertTrue(model.look().isNotRealTime());
    assertTrue(model.look().note().contains("no real-time rights"));
  }

  @Test
  void aThreadWithOverrunsIsAWarningAndSaysWhy() {
    put();
    LoopLine slow = (LoopLine) line("loop motion/slow");
    assertEquals(Health.WARNING, slow.health());
    assertTrue(slow.words().endsWith("3 overruns \u00b7 17 allocations \u00b7 2 page faults"), slow.words());
    assertEquals("every 10.0\u00a0ms, real-time priority 60, any processor", slow.scheduled());
  }

  @Test
  void startingTakesControlAndAsksTheControl() {
    put();
    model.verbs().ask("sine", Verb.START, "");
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().holder());
    assertEquals(new PluginRequest("sine", Verb.START, ""), caller.made().getFirst().request());
    assertEquals(TIMEOUT, caller.made().getFirst().timeout());
    model.tick(0);
    assertTrue(((PluginLine) line("plugin sine")).isTurning());
    assertFalse(((PluginLine) line("plugin sine")).isSwitchable());
    answer(new CallOutcome.Replied<>(new PluginReply(true, "")));
    assertEquals(new PluginNotice(Health.OK, "Started"), told("sine"));
  }

  @Test
  void oneRequestAPluginAtATime() {
    model.verbs().ask("sine", Verb.START, "");
    model.verbs().ask("sine", Verb.STOP, "");
    model.verbs().ask("homing", Verb.STOP, "");
    assertEquals(2, caller.made().size());
  }

  @Test
  void aRefusalIsToldWhole() {
    put();
    model.verbs().ask("sine", Verb.START, "");
    answer(new CallOutcome.Replied<>(new PluginReply(false, "sine needs arm_1\nwhich homing owns")));
    PluginDetail detail = PluginDetail.of(model.look(), "plugin sine").orElseThrow();
    assertEquals("Not started: sine needs arm_1\nwhich homing owns", detail.problem());
    assertTrue(((PluginLine) line("plugin sine")).isSwitchable());
  }

  @Test
  void whatWasToldGoesWhenThePluginChanges() {
    put();
    model.verbs().ask("sine", Verb.START, "");
    answer(new CallOutcome.Replied<>(new PluginReply(false, "homing runs")));
    assertEquals(Health.BAD, told("sine").health());
    List<ControlPlugins.Plugin> changed = new ArrayList<>(Controls.arm().plugins());
    changed.set(2, Controls.plugin("sine", "motion", "fast", State.RUNNING, "", "", Controls.nothing()));
    plugins.put(new ControlPlugins(changed));
    model.tick(0);
    assertFalse(model.look().told().containsKey("sine"));
  }

  @Test
  void silenceAndFailureAreTold() {
    model.verbs().ask("homing", Verb.STOP, "");
    answer(new CallOutcome.TimedOut<>());
    assertEquals("Not stopped: the control did not answer in time", told("homing").text());
    model.verbs().ask("homing", Verb.COMMAND, "speed 2");
    answer(new CallOutcome.Failed<>("Keira is stopped by You; release the stop first"));
    assertEquals("\u201cspeed 2\u201d was not taken: Keira is stopped by You; release the stop first",
        told("homing").text());
  }

  @Test
  void somebodyElseIsTakenOverOnlyWhenTheUserSaysSo() {
    context.authority().take(FakeAuthority.ANNA, false);
    model.verbs().ask("sine", Verb.START, "");
    model.tick(0);
    assertEquals("Anna", model.look().question().orElseThrow().holder());
    assertTrue(caller.made().isEmpty());
    model.control().leave();
    model.tick(0);
    assertTrue(model.look().question().isEmpty());
    assertFalse(model.verbs().isPending("sine"));
    model.verbs().ask("sine", Verb.START, "");
    model.control().takeOver();
    assertEquals(1, caller.made().size());
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().holder());
  }

  @Test
  void whatIsStaleSaysSoAndCannotBeSwitched() {
    put();
    assertTrue(model.look().usable());
    plugins.state(new InputState.Stale(3, "silent"));
    model.tick(0);
    assertFalse(model.look().usable());
    PluginDetail detail = PluginDetail.of(model.look(), "plugin homing").orElseThrow();
    assertEquals(Health.STALE, detail.health());
    assertTrue(detail.status().startsWith("stale 3.0\u00a0s, then running"), detail.status());
  }

  @Test
  void withoutAControlNothingIsAsked() {
    PluginsModel alone = new PluginsModel(context, plugins, timing, drives, new FakeCaller<>(), () -> TIMEOUT);
    alone.verbs().ask("sine", Verb.START, "");
    alone.tick(0);
    assertFalse(alone.look().switchable());
    assertEquals(Health.BAD, alone.look().told().get("sine").health());
    assertTrue(context.authority().holder().isEmpty());
  }

  @Test
  void aFailedPluginMustBeLoadedFirst() {
    put();
    PluginLine failed = (PluginLine) line("plugin cartesian");
    assertFalse(failed.isSwitchable());
    assertTrue(failed.isReloadable());
    assertEquals("the library libcartesian.so could not be loaded", failed.words());
    PluginDetail detail = PluginDetail.of(model.look(), "plugin cartesian").orElseThrow();
    assertEquals(4, detail.problem().lines().count());
    assertTrue(detail.status().contains("started again 3 times"));
    assertFalse(((PluginLine) line("plugin homing")).isReloadable());
  }

  @Test
  void aPluginThatWasStoppedByTheDeathOfItsProcessIsSeenAmongTheOthersAndCanBeStarted() {
    List<ControlPlugins.Plugin> changed = new ArrayList<>(Controls.arm().plugins());
    changed.set(0, Controls.plugin("homing", "motion", "fast", State.STOPPED, "",
        "The process of the host motion ended by signal 11.", Controls.nothing()));
    plugins.put(new ControlPlugins(changed));
    model.tick(0);
    PluginLine lost = (PluginLine) line("plugin homing");
    assertEquals(Health.BAD, lost.health());
    assertTrue(lost.isSwitchable());
    assertTrue(lost.isReloadable());
    assertEquals(Health.NONE, line("plugin sine").health());
  }

  @Test
  void aResetCountsFromThenOn() {
    put();
    model.reset(0);
    assertTrue(line("plugin homing").busy().isEmpty());
    assertEquals("0 cycles \u00b7 0 overruns \u00b7 0 missed \u00b7 0 allocations \u00b7 0 page faults",
        PluginDetail.of(model.look(), "loop motion/slow").orElseThrow().counts());
    assertEquals(Health.OK, line("loop motion/slow").health());
    model.tick(12_000_000_000L);
    assertEquals("since the reset 12\u00a0s ago", model.look().since());
    model.sinceStart(0);
    assertEquals(Health.WARNING, line("loop motion/slow").health());
    assertEquals("since the start", model.look().since());
  }

  @Test
  void afterAResetARespawnedPluginCountsFromItsStart() {
    put();
    model.reset(0);
    ControlPlugins.Plugin old = Controls.arm().plugins().getFirst();
    List<ControlPlugins.Plugin> changed = new ArrayList<>(Controls.arm().plugins());
    changed.set(0,
        new ControlPlugins.Plugin(old.name(), old.type(), old.process(), old.thread(), State.RUNNING, "", "", 1,
            old.period(), 500,
            Controls.durations(500, 20_000, 30_000)));
    plugins.put(new ControlPlugins(changed));
    model.tick(0);
    assertTrue(line("plugin homing").busy().histogram().count() >= 490);
  }

  @Test
  void whatIsNotConnectedAnyMoreIsNotShown() {
    put();
    plugins.state(new InputState.Unconnected("gone"));
    model.tick(0);
    assertTrue(model.look().lines().isEmpty());
  }

  @Test
  void whatMattersLeastGoesFirst() {
    assertEquals(PluginColumn.values().length, PluginColumn.places(1200).size());
    Map<PluginColumn, PluginColumn.Place> narrow = PluginColumn.places(330);
    assertEquals(List.of(PluginColumn.SWITCH, PluginColumn.NAME, PluginColumn.STATE), List.copyOf(narrow.keySet()));
  }

  private void put() {
    plugins.put(Controls.arm());
    timing.put(Controls.timing(true));
    model.tick(0);
  }

  private void answer(CallOutcome<PluginReply> outcome) {
    caller.made().getLast().end().complete(outcome);
    model.tick(0);
  }

  private PluginNotice told(String plugin) {
    return model.look().told().get(plugin);
  }

  private Line line(String key) {
    return model.look().lines().stream().filter(line -> line.key().equals(key)).findFirst().orElseThrow();
  }
}
