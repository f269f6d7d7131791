package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.custom.StyledText;
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
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.link.LinkState;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeHost;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.NewRobotModel;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class NewRobotDialogTest {
  private static final Path FILE = Path.of("/x/robot.yaml");
  private static final Schema PLAYER = Schema.of(
      Setting.required("host", new ValueType.Text(), "name of the server"),
      Setting.of("port", new ValueType.Int(1, 65535), 6665, "its port"));

  private final List<String> calls = new ArrayList<>();
  private final List<RuicDraft> drafts = new ArrayList<>();
  private final FakeHost host = new FakeHost()
      .installed(new Installed(Installed.Kind.RFIC, new Descriptor("player", "Player", "", PLAYER, List.of()), "b",
          Optional.empty(), List.of()))
      .composing(Robot::new)
      .checking((s, v) -> s.name().equals("port") && !v.toString().matches("[0-9]+")
          ? Optional.of("'port' must be a whole number")
          : Optional.empty());
  private Stage stage = Stage.FOUND;
  private Optional<String> refused = Optional.empty();
  private Shell parent;
  private Theme theme;
  private NewRobotDialog dialog;

  /** A robot that a map fits. */
  private final class Robot implements Composition {
    Robot(InterfaceConfig wanted) {
      calls.add("compose " + wanted.settings());
    }

    @Override
    public CompositionState state() {
      return new CompositionState(stage, "", new LinkState.Connected("here"), List.of(),
          stage == Stage.FOUND ? List.of(new ViewFit("map", "Map", "", ViewFit.Fit.CONNECTED, "", List.of()))
              : List.of(),
          List.of(new RuicFit("rover", "Rover", "", List.of("map"), 0.7, "")));
    }

    @Override
    public CompositionText text(RuicDraft draft) {
      drafts.add(draft);
      return refused.<CompositionText>map(why -> new CompositionText.Refused(CompositionText.Field.FILE, why))
          .orElseGet(() -> new CompositionText.Text(draft.file(), "ruics:\n  " + draft.name() + ":\n",
              "  " + draft.name() + ":\n", 2, true));
    }

    @Override
    public CompositionText write(RuicDraft draft, CompositionText.Text shown) {
      calls.add("write " + draft.name());
      return refused.<CompositionText>map(why -> new CompositionText.Refused(CompositionText.Field.FILE, why))
          .orElse(shown);
    }

    @Override
    public void close() {
      calls.add("close");
    }
  }

  @BeforeEach
  void open() {
    parent = new Shell(TestDisplay.get());
    parent.setBounds(0, 0, 1400, 900);
    theme = Themes.of(TestDisplay.get(), Themes.DARK);
    dialog = new NewRobotDialog(parent, theme, host, new NewRobotModel(host, FILE), List.of(), Runnable::run,
        (file, name) -> calls.add("done " + name + " " + file.getFileName()));
    dialog.open();
  }

  @AfterEach
  void close() {
    parent.dispose();
    theme.dispose();
  }

  private <C extends Control> List<C> all(Class<C> type) {
    return Controls.all(dialog.shell(), type);
  }

  private QuietButton connect() {
    return all(QuietButton.class).getFirst();
  }

  private QuietButton next() {
    return all(QuietButton.class).getLast();
  }

  private QuietButton back() {
    List<QuietButton> buttons = all(QuietButton.class);
    return buttons.get(buttons.size() - 2);
  }

  private Text settingsHost() {
    return all(Text.class).getFirst();
  }

  /** The field for the name is the last but the file's. */
  private void name(String name) {
    List<Text> fields = all(Text.class);
    fields.get(fields.size() - 2).setText(name);
  }

  private void reach() {
    settingsHost().setText("keira");
    connect().press();
    TestDisplay.until(() -> next().getEnabled());
  }

  @Test
  void whatIsNotTriedCannotBeGoneOnWithAndWhatIsWrongCannotBeTried() {
    assertFalse(next().getEnabled());
    assertFalse(connect().getEnabled(), "the host is needed");
    settingsHost().setText("keira");
    assertTrue(connect().getEnabled());
    all(Text.class).get(1).setText("many");
    assertFalse(connect().getEnabled(), "the port is no number");
    assertEquals(List.of(), calls);
  }

  @Test
  void aRobotThatIsNotReachedIsNoWayOn() {
    stage = Stage.UNREACHED;
    settingsHost().setText("keira");
    connect().press();
    assertEquals(List.of("compose {host=keira}"), calls);
    assertFalse(next().getEnabled());
    stage = Stage.FOUND;
    TestDisplay.until(() -> next().getEnabled());
  }

  @Test
  void threeStepsWriteTheFileAndTheWindowCloses() {
    reach();
    next().press();
    assertTrue(back().getEnabled());
    next().press();
    name("Keira");
    TestDisplay.until(() -> all(StyledText.class).getFirst().getText().contains("Keira:"));
    assertEquals("keira.yaml", drafts.getLast().file().getFileName().toString(), "the file is called after the robot");
    assertEquals(List.of("map"), drafts.getLast().views());
    assertFalse(calls.contains("write Keira"), "nothing is written before the last button");
    TestDisplay.until(() -> next().getEnabled());
    next().press();
    TestDisplay.until(dialog::isClosed);
    assertEquals(List.of("compose {host=keira}", "write Keira", "close", "done Keira keira.yaml"), calls);
  }

  @Test
  void aFileThatCannotBeAddedToIsNotWritten() {
    refused = Optional.of("robot.yaml:1: 'ruics' stands in braces there");
    reach();
    next().press();
    next().press();
    name("Keira");
    TestDisplay.until(() -> !drafts.isEmpty() && drafts.getLast().name().equals("Keira"));
    assertFalse(next().getEnabled());
    assertEquals("", all(StyledText.class).getFirst().getText());
    back().press();
    assertTrue(next().getEnabled(), "the steps before are as they were");
    assertFalse(dialog.isClosed());
  }

  @Test
  void otherSettingsEndWhatWasTried() {
    reach();
    settingsHost().setText("other");
    assertFalse(next().getEnabled());
    assertEquals(List.of("compose {host=keira}", "close"), calls);
  }

  @Test
  void closingItEndsTheTrial() {
    reach();
    dialog.shell().close();
    assertTrue(dialog.isClosed());
    assertEquals(List.of("compose {host=keira}", "close"), calls);
  }
}
