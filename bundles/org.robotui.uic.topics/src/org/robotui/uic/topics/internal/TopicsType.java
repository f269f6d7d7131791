package org.robotui.uic.topics.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.show.Showing;
import org.robotui.data.Data;

/** What a robot has: topics, nodes, services and actions, and what goes through them. */
@Component(service = UicType.class)
public final class TopicsType implements UicType {
  static final String ECHO = "echo";
  static final String ABOUT = "about";
  static final String NODE = "node";

  /** As fast as messages may be repeated. */
  private static final double RATE_HZ = 50;

  private static final Descriptor DESCRIPTOR = new Descriptor("topics", "Topics",
      "Topics, nodes, services and actions of a robot: their types, rates and messages; publishes messages from a form.",
      TopicsOptions.schema(), TopicsPorts.all());

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public List<Showing> showings() {
    return List.of(Showing.streams(ECHO, "Echo", List.of(Data.class)),
        Showing.streams(ABOUT, "Show in Topics", List.of(Data.class)),
        Showing.nodes(NODE, "Show in Topics"));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new TopicsUic(context);
  }
}
