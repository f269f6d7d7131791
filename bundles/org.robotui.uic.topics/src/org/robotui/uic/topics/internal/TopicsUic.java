package org.robotui.uic.topics.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.view.TopicsActions;
import org.robotui.uic.topics.internal.view.TopicsSurface;

/** The view: the model is prepared by ticks, the surface shows it. */
final class TopicsUic implements SwtUic {
  private final UicContext context;
  private final TopicsModel model;
  private final TopicsActions actions;
  private Optional<TopicsSurface> surface = Optional.empty();

  TopicsUic(UicContext context) {
    this.context = context;
    this.model = new TopicsModel(context);
    this.actions = new TopicsActions(model);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, options());
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    TopicsSurface made = new TopicsSurface(parent, ui, model, this::options,
        context.ruic().name(), new SubjectMenu(context.ruic(), ui.theme(), context.background()));
    surface = Optional.of(made);
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Echo the topic"),
        new ViewKey("M", "Measure its rate"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("H", "Pause the echo"),
        new ViewKey("Ctrl+Enter", "Publish once, in the form"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(TopicsSurface::refresh);
  }

  @Override
  public void show(String showing, Subject subject) {
    surface.ifPresent(shown -> {
      switch (subject) {
        case Subject.Stream stream -> shown.show(stream.port(), showing.equals(TopicsType.ECHO));
        case Subject.Node node -> shown.showNode(node.name());
        case Subject.Frame frame -> {}
      }
    });
  }

  @Override
  public List<ViewAction> actions() {
    return actions.all();
  }

  @Override
  public void close() {
    model.close();
  }

  private TopicsOptions options() {
    return TopicsOptions.of(context.settings().current());
  }
}
