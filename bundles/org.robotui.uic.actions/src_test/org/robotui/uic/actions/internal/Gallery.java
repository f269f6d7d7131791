package org.robotui.uic.actions.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ask.AskModel;
import org.robotui.ui.ask.AskPane;
import org.robotui.ui.ask.AskWords;
import org.robotui.ui.ask.Catalogue;
import org.robotui.ui.ask.Questions;

/** Shows views that ask in all their states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  private static final SourceId GRAPH = new SourceId("base", "graph");
  private static final RecordShape POINT = new RecordShape("geometry_msgs/Point", List.of(
      new RecordShape.Field("x", new FieldShape.Real(64)), new RecordShape.Field("y", new FieldShape.Real(64)),
      new RecordShape.Field("z", new FieldShape.Real(64))), List.of());
  private static final RecordShape GOAL = new RecordShape("move_base_msgs/MoveBaseGoal", List.of(
      new RecordShape.Field("frame_id", new FieldShape.Text()),
      new RecordShape.Field("position", new FieldShape.Nested(POINT)),
      new RecordShape.Field("tolerance", new FieldShape.Real(32)),
      new RecordShape.Field("retry", new FieldShape.Flag())), List.of());

  private record Robot(List<Item> items, Optional<String> refusal) implements Browser {
    @Override
    public List<Item> list(Kind kind) throws CallException {
      if (refusal.isPresent()) {
        throw new CallException(refusal.get());
      }
      return items;
    }

    @Override
    public Description describe(Item item) {
      return new Description(item, Map.of("type", item.type(), "servers", "/move_base"), Optional.empty(),
          Optional.of(GOAL),
          Optional.empty());
    }

    @Override
    public Optional<Object> parameter(String name) {
      return Optional.empty();
    }

    @Override
    public void setParameter(String name, Object value) {
      throw new UnsupportedOperationException(name);
    }

    @Override
    public List<Tunable> tunables(Item item) {
      return List.of();
    }

    @Override
    public List<Tunable> setTunables(Item item, Map<String, Object> values) {
      return List.of();
    }
  }

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private static List<Browser.Item> items() {
    return List.of(new Browser.Item(Browser.Kind.ACTION, "/move_base", "move_base_msgs/MoveBaseAction"),
        new Browser.Item(Browser.Kind.ACTION, "/arm/follow_joint_trajectory",
            "control_msgs/FollowJointTrajectoryAction"),
        new Browser.Item(Browser.Kind.ACTION, "/dock", "kobuki_msgs/AutoDockingAction"));
  }

  private void fill() {
    Catalogue.Entry move = new Catalogue.Entry(GRAPH, items().getFirst());
    cell(0, 0, 1000, 560, items(), Optional.empty(), model -> {
      model.choose(move);
      ask(model, move);
    });
    cell(1006, 0, 594, 330, items(), Optional.empty(), model -> {});
    cell(1006, 336, 594, 224, items(), Optional.of("the master at robot:11311 does not answer"), model -> {});
    cell(0, 566, 262, 434, List.of(), Optional.empty(), model -> {});
    cell(606, 566, 500, 434, items(), Optional.empty(), model -> {
      model.choose(move);
      model.questions().ask(move, Map.of());
    });
    cell(1112, 566, 488, 434, items(), Optional.empty(), model -> model.filter("nowhere"));
    cell(268, 566, 332, 434, items(), Optional.empty(), model -> {
      model.choose(move);
      ask(model, move);
    });
  }

  private static void ask(AskModel model, Catalogue.Entry move) {
    for (int i = 0; i < 3; i++) {
      model.questions().ask(move, Map.of("end", i));
    }
  }

  private void cell(
      int x, int y, int width, int height, List<Browser.Item> items, Optional<String> refusal,
      Consumer<AskModel> prepare) {
    FakeUicContext context = new FakeUicContext("actions", new ActionsType().schema());
    context.robots(List.of(new BrowseInput.Robot(GRAPH, new Robot(items, refusal))));
    AskModel model = new AskModel(
        new Catalogue(context.browse(ActionsType.GRAPH), context.background(), Browser.Kind.ACTION),
        new Questions((entry, values, report) -> {
          int end = (int) values.getOrDefault("end", 2);
          report.progress(end == 2 ? "active" : "sent");
          report.feedback(new MapRecord("Feedback", Map.of("distance", new FieldValue.Num(2.4, "2.4"),
              "frame_id", new FieldValue.Text("map"))));
          if (end < 2) {
            report.end(end == 0 ? Health.OK : Health.BAD, end == 0 ? "succeeded" : "aborted: no way leads there",
                Optional.empty());
          }
          return () -> {};
        }));
    model.tick(System.nanoTime());
    Composite cell = window.cell(x, y, width, height);
    prepare.accept(model);
    new AskPane(cell, UiContext.of(theme, text -> {}), model,
        new AskWords(Browser.Kind.ACTION, "actions", "Send goal", "Goal", "Result", true));
    cell.layout(true, true);
  }
}
