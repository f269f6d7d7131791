package org.robotui.uic.topics.internal.view;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Browser.Kind;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.topics.internal.model.Fact;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.MessageContent.FieldChange;
import org.robotui.uic.topics.internal.model.TimedMessage;
import org.robotui.uic.topics.internal.model.TopicRow;

/** A surface in the hands of a test. */
public final class Stage {
  private final TopicsSurface surface;

  public Stage(TopicsSurface surface) {
    this.surface = surface;
  }

  public void select(String topic) {
    select(Kind.TOPIC, topic);
  }

  public void select(Kind kind, String name) {
    surface.follow(new Key("base", kind, name));
  }

  public void section(Kind kind) {
    surface.section(kind);
  }

  public void open() {
    surface.detail().open();
  }

  public void messages() {
    surface.detail().open(TopicDetailPane.Leaf.MESSAGES);
  }

  public RowTable<TimedMessage> listed() {
    return surface.detail().messages().list();
  }

  /** What has changed in the message that is shown, by the names of the fields. */
  public List<String> changed() {
    return surface.detail().messages().changes().list().rows().stream().map(FieldChange::path).toList();
  }

  public List<String> letters() {
    return surface.detail().messages().bytes().list().rows().stream().map(BytesLines.Line::letters).toList();
  }

  public void publish() {
    surface.detail().open(TopicDetailPane.Leaf.PUBLISH);
  }

  public void publishOnce() {
    surface.refresh();
    surface.detail().publish().say();
  }

  public void repeat() {
    surface.refresh();
    surface.detail().publish().repeat();
  }

  public void filter(String words) {
    surface.filterField().words(words);
  }

  public RowTable<TopicRow> table() {
    return surface.shelf().table();
  }

  public void followFact(String value) {
    Optional<Fact> fact =
        surface.detail().about().facts().rows().stream().filter(f -> f.value().equals(value)).findFirst();
    fact.flatMap(Fact::target).ifPresent(surface::follow);
  }
}
