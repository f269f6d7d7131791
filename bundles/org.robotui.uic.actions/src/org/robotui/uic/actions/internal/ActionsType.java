package org.robotui.uic.actions.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallPort;
import org.robotui.ui.ask.AskUic;
import org.robotui.ui.ask.AskWords;

/** Sends goals to the actions of robots from a form, and follows them. */
@Component(service = UicType.class)
public final class ActionsType implements UicType {
  static final String TIMEOUT = "timeout";
  static final BrowsePort GRAPH = new BrowsePort("graph", Arity.MANY, "The actions that there are.");
  static final CallPort<ActionRequest, ActionReply> ACTIONS = new CallPort<>(
      "actions", ActionRequest.class, ActionReply.class, Arity.MANY, "Where goals are sent.", true);

  private static final AskWords WORDS = new AskWords(Kind.ACTION, "actions", "Send goal", "Goal", "Result", true);
  private static final double RATE_HZ = 10;
  private static final Schema SCHEMA = Schema.of(
      Setting.of(TIMEOUT, new ValueType.Num(1, 86_400, "s"), 3600.0,
          "How long a goal may take; then it is cancelled."));

  private static final Descriptor DESCRIPTOR = new Descriptor("actions", "Actions",
      "Sends goals to the actions of a robot from a form, with feedback, result and cancelling.",
      SCHEMA, List.of(GRAPH, ACTIONS));

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
  public Uic create(UicContext context, Settings settings) {
    return new AskUic(context, GRAPH, WORDS, new ActionAsker(context));
  }
}
