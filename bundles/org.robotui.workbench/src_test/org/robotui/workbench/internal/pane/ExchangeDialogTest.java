package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.Descriptor;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Line;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeExchange;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.ExchangeModel;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class ExchangeDialogTest {
  private static final Schema ROS =
      Schema.of(Setting.optional("master", new ValueType.Text(), "address of the master"));
  private static final Schema PLAYER = Schema.of(
      Setting.required("port", new ValueType.Int(1, 65535), "port of the server"),
      Setting.of("data", new ValueType.Choice(List.of("push", "pull")), "push", "how data come"),
      Setting.of("devices",
          new ValueType.AnyOf(List.of(new ValueType.Text(), new ValueType.ListOf(new ValueType.Text()))),
          List.of("*"), "which devices"));

  private final List<String> done = new ArrayList<>();
  private final List<InterfaceConfig> wanted = new ArrayList<>();
  private final FakeExchange trial = new FakeExchange();
  private final FakeHost host = new FakeHost()
      .installed(type("ros", "ROS 1", ROS), type("player", "Player", PLAYER))
      .checking((s, v) -> s.name().equals("port") && !v.toString().matches("[0-9]+")
          ? Optional.of("'port' must be a whole number")
          : Optional.empty());
  private final FakeRuic ruic = new FakeRuic("Natalie").exchanging(w -> {
    wanted.add(w);
    return trial;
  }, new InterfaceConfig("base", "ros", "Natalie", "", Map.of("master", "http://robot:11311")));
  private Shell parent;
  private Theme theme;
  private ExchangeModel model;
  private ExchangeDialog dialog;

  private static Installed type(String id, String label, Schema schema) {
    return new Installed(Installed.Kind.RFIC, new Descriptor(id, label, "", schema, List.of()),
        "org.robotui.rfic." + id,
        Optional.empty(), List.of());
  }

  @BeforeEach
  void open() {
    parent = new Shell(TestDisplay.get());
    parent.setBounds(0, 0, 1400, 900);
    theme = Themes.of(TestDisplay.get(), Themes.DARK);
    model = new ExchangeModel(host, ruic);
    dialog = new ExchangeDialog(parent, theme, host, model, done::add);
    dialog.open();
  }

  @AfterEach
  void close() {
    parent.dispose();
    theme.dispose();
  }

  private static Line line(String port, MatchState state, String peer, boolean lost) {
    SourceId view = new SourceId("map", port);
    Match now = new Match(view, PortKind.STREAM, "LaserScan", Arity.ONE, MatchState.CONNECTED,
        List.of(new SourceId("base", "scan")), List.of(), "");
    Match then = new Match(view, PortKind.STREAM, "LaserScan", Arity.ONE, state,
        peer.isEmpty() ? List.of() : List.of(new SourceId("base", peer)),
        state == MatchState.AMBIGUOUS ? List.of(new SourceId("base", "laser:0"), new SourceId("base", "laser:1"))
            : List.of(),
        "so it is");
    return new Line(now, then, true, lost);
  }

  private static ExchangePreview preview(Verdict verdict, List<String> missing, Line... lines) {
    return new ExchangePreview(verdict, "said so", new LinkState.Connected("robot"), List.of(lines), missing,
        List.of());
  }

  private <C extends Control> List<C> all(Class<C> type) {
    return Controls.all(dialog.shell(), type);
  }

  private QuietButton button(int index) {
    return all(QuietButton.class).get(index);
  }

  private QuietButton tryIt() {
    return button(2);
  }

  private QuietButton exchange() {
    return button(3);
  }

  @Test
  void theFormBeginsWithWhatRunsAndNothingCanBeExchangedUntried() {
    assertEquals(List.of("Natalie", "http://robot:11311"), all(Text.class).stream().map(Text::getText).toList());
    assertFalse(exchange().getEnabled());
    assertTrue(tryIt().getEnabled());
  }

  @Test
  void theFormIsMadeFromTheSchemaAndMistakesForbidTheTrial() {
    dialog.want(new InterfaceConfig("base", "player", "Natalie", "", Map.of()));
    List<Text> fields = all(Text.class);
    assertEquals(List.of("Natalie", "needed", "*"),
        List.of(fields.get(0).getText(), fields.get(1).getMessage(), fields.get(2).getMessage()));
    assertFalse(tryIt().getEnabled(), "the port is needed");
    fields.get(1).setText("many");
    assertFalse(tryIt().getEnabled(), "the port is no number");
    fields.get(1).setText("6665");
    fields.get(2).setText("laser, position2d");
    assertTrue(tryIt().getEnabled());
    tryIt().press();
    InterfaceConfig tried = wanted.getLast();
    assertEquals(Map.of("port", "6665", "devices", List.of("laser", "position2d")), tried.settings());
    assertEquals("Natalie", tried.robot());
  }

  @Test
  void whatIsCoveredIsExchangedAndTheWindowCloses() {
    trial.saying(preview(Verdict.READY, List.of(), line("scan", MatchState.CONNECTED, "laser:0", false)));
    dialog.want(new InterfaceConfig("base", "player", "Natalie", "", Map.of("port", "6665")));
    tryIt().press();
    TestDisplay.until(() -> exchange().getEnabled());
    exchange().press();
    TestDisplay.until(() -> !done.isEmpty());
    assertEquals(List.of("Natalie: base is Player now"), done);
    assertTrue(dialog.isClosed());
    assertEquals(List.of("apply false"), trial.calls());
  }

  @Test
  void whatIsMissingIsLeftOutOnlyWhereTheUserSaysSo() {
    trial.saying(
        preview(Verdict.INCOMPLETE, List.of("map needs LaserScan"), line("scan", MatchState.REFUSED, "", true)));
    tryIt().press();
    TestDisplay.until(() -> exchange().getEnabled());
    exchange().press();
    TestDisplay.until(() -> !done.isEmpty());
    assertEquals(List.of("apply true"), trial.calls());
  }

  @Test
  void whatCannotBeStartedCannotBeExchanged() {
    trial.saying(preview(Verdict.FAILED, List.of()));
    tryIt().press();
    dialog.want(model.wanted());
    assertFalse(exchange().getEnabled());
  }

  @Test
  void typingEndsATrialOfWhatWasWantedBefore() {
    trial.saying(preview(Verdict.READY, List.of(), line("scan", MatchState.CONNECTED, "laser:0", false)));
    tryIt().press();
    TestDisplay.until(() -> exchange().getEnabled());
    all(Text.class).get(1).setText("http://other:11311");
    assertFalse(exchange().getEnabled());
    assertEquals(List.of("close"), trial.calls());
  }

  @Test
  void goingBackIsSaidAndTheWindowStays() {
    trial.saying(preview(Verdict.READY, List.of(), line("scan", MatchState.CONNECTED, "laser:0", false)))
        .ending(new ExchangeOutcome.WentBack("the robot has gone"));
    tryIt().press();
    TestDisplay.until(() -> exchange().getEnabled());
    exchange().press();
    TestDisplay.until(() -> !exchange().getEnabled() && tryIt().getEnabled());
    assertFalse(dialog.isClosed());
    assertEquals(List.of(), done);
  }

  @Test
  void escapeClosesAndEndsTheTrial() {
    tryIt().press();
    dialog.shell().close();
    assertTrue(dialog.isClosed());
    assertEquals(List.of("close"), trial.calls());
  }
}
