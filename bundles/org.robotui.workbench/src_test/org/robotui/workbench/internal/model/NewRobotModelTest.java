package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Descriptor;
import org.robotui.api.config.Schema;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.host.ViewFit.Fit;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeHost;
import org.robotui.ui.Health;

class NewRobotModelTest {
  private static final SourceId IMAGE = new SourceId("camera", "image");
  private static final SourceId FRONT = new SourceId("base", "front/raw");
  private static final SourceId RAW = new SourceId("base", "raw");
  private static final CompositionState FOUND =
      new CompositionState(Stage.FOUND, "", new LinkState.Connected("here"), List.of(),
          List.of(view("map", Fit.CONNECTED), view("plot", Fit.CONNECTED),
              new ViewFit("camera", "Camera", "", Fit.AMBIGUOUS, "",
                  List.of(new Match(IMAGE, PortKind.STREAM, "Image", Arity.ONE, MatchState.AMBIGUOUS, List.of(),
                      List.of(FRONT, RAW), ""))),
              view("gps", Fit.MISSING)),
          List.of(new RuicFit("rover", "Rover", "", List.of("camera", "gps", "map"), 0.7, ""),
              new RuicFit("single", "Single", "", List.of("map"), 0.4, "")));

  private final List<String> calls = new ArrayList<>();
  private NewRobotModel model;

  private static ViewFit view(String type, Fit fit) {
    return new ViewFit(type, type, "", fit, "", List.of());
  }

  /** Says what was found. */
  private final class Found implements Composition {
    private final InterfaceConfig wanted;

    Found(InterfaceConfig wanted) {
      this.wanted = wanted;
      calls.add("compose " + wanted.type() + wanted.settings() + wanted.robot());
    }

    @Override
    public CompositionState state() {
      return FOUND;
    }

    @Override
    public CompositionText text(RuicDraft draft) {
      throw new UnsupportedOperationException();
    }

    @Override
    public CompositionText write(RuicDraft draft, CompositionText.Text shown) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void close() {
      calls.add("close " + wanted.type());
    }
  }

  private static Installed rfic(String id) {
    return new Installed(Installed.Kind.RFIC, new Descriptor(id, id, "", Schema.EMPTY, List.of()), "b",
        Optional.empty(), List.of());
  }

  @BeforeEach
  void connect() {
    model = new NewRobotModel(new FakeHost().installed(rfic("lcm"), rfic("ros")).composing(Found::new),
        Path.of("/x/robot.yaml"));
    model.connect();
  }

  @Test
  void itBeginsWithWhatIsProposed() {
    assertEquals(List.of("compose ros{}"), calls);
    assertEquals(List.of("camera", "map"), model.views(FOUND),
        "of the best type what fits, in the order of its layout");
    assertEquals(Map.of(IMAGE, RAW), model.connections(FOUND), "the plain one of two");
  }

  @Test
  void theUsersChoicesHoldUntilAnotherTypeIsChosen() {
    model.flip(FOUND, "camera");
    model.flip(FOUND, "plot");
    assertEquals(List.of("map", "plot"), model.views(FOUND));
    assertEquals(Map.of(), model.connections(FOUND), "of a view that is left out nothing is written");
    model.ruic("single");
    assertEquals(List.of("map"), model.views(FOUND));
  }

  @Test
  void thePortThatWasChosenIsWritten() {
    model.choose(IMAGE, FRONT);
    model.name(" Keira ");
    RuicDraft draft = model.draft().orElseThrow();
    assertEquals(Map.of(IMAGE, FRONT), draft.connections());
    assertEquals("Keira", draft.name());
  }

  @Test
  void otherSettingsEndWhatWasTriedAndTheRobotsNameIsNoSetting() {
    model.want("lcm", Map.of("robot", "K", "url", "x"));
    assertTrue(model.state().isEmpty());
    model.connect();
    model.close();
    assertEquals(List.of("compose ros{}", "close ros", "compose lcm{url=x}K", "close lcm"), calls);
  }

  @Test
  void rowsShowWhatIsChosenFirstAndPortsBelowTheirViews() {
    List<NewViewRow> rows = rows();
    assertEquals(List.of("camera", "camera.image", "map", "plot", "gps"), rows.stream().map(NewViewRow::key).toList());
    assertEquals(List.of("ambiguous", "choose", "connected", "connected", "does not fit"),
        rows.stream().map(NewViewRow::state).toList());
    assertTrue(rows.get(1).why().startsWith("raw is taken; 2 fit"), rows.get(1)::why);
    assertTrue(rows.get(3).why().startsWith("not part of Rover"), rows.get(3)::why);
  }

  @Test
  void whatTheUserHasChosenIsNoLongerAmbiguous() {
    model.choose(IMAGE, FRONT);
    List<NewViewRow> rows = rows();
    assertEquals(List.of("connected", "chosen"), rows.stream().map(NewViewRow::state).limit(2).toList());
    assertEquals(List.of(Health.OK, Health.OK), rows.stream().map(NewViewRow::health).limit(2).toList());
    assertTrue(rows.get(1).why().startsWith("front/raw is taken"), rows.get(1)::why);
  }

  private List<NewViewRow> rows() {
    return NewViewRow.of(FOUND, model.ruic(FOUND).orElseThrow(), model.views(FOUND), model.connections(FOUND),
        model.decided());
  }
}
