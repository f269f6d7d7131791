package org.robotui.uic.topics.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.show.Subject;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.view.TopicsSurface;

/** The view: the model is prepared by ticks, the surface shows it. */
final class TopicsUic extends SurfaceUic<TopicsSurface> {
  private final UicContext context;
  private final TopicsModel model;

  TopicsUic(UicContext context) {
    this.context = context;
    this.model = new TopicsModel(context);
    offers().add("pause", "Pause the echo", Icon.PAUSE, () -> model.look().wishes().paused(),
        () -> model.pause(!model.look().wishes().paused()))
        .add("refresh", "Refresh", Icon.RESTART, model::refresh);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos, options());
  }

  @Override
  protected TopicsSurface open(Composite parent, UiContext ui) {
    return new TopicsSurface(parent, ui, model, this::options,
        context.ruic().name(), new SubjectMenu(context, ui.theme()));
  }

  @Override
  protected void refresh(TopicsSurface shown) {
    shown.refresh();
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
  public void show(String showing, Subject subject) {
    surface().ifPresent(shown -> {
      switch (subject) {
        case Subject.Stream stream -> shown.show(stream.port(), showing.equals(TopicsType.ECHO));
        case Subject.Node node -> shown.showNode(node.name());
        case Subject.Frame frame -> {}
      }
    });
  }

  @Override
  public void close() {
    model.close();
  }

  private TopicsOptions options() {
    return TopicsOptions.of(context.settings().current());
  }
}
