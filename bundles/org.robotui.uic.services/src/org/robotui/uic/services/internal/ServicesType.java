package org.robotui.uic.services.internal;

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
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.ui.ask.AskUic;
import org.robotui.ui.ask.AskWords;

/** Calls the services of robots from a form. */
@Component(service = UicType.class)
public final class ServicesType implements UicType {
  static final String TIMEOUT = "timeout";
  static final BrowsePort GRAPH = new BrowsePort("graph", Arity.MANY, "The services that there are.");
  static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, "Where services are called.");

  private static final AskWords WORDS = new AskWords(Kind.SERVICE, "services", "Call", "Request", "Reply", false);
  private static final double RATE_HZ = 10;
  private static final Schema SCHEMA = Schema.of(
      Setting.of(TIMEOUT, new ValueType.Num(0.1, 3600, "s"), 10.0, "How long a call may take."));

  private static final Descriptor DESCRIPTOR = new Descriptor("services", "Services",
      "Calls the services of a robot from a form.",
      SCHEMA, List.of(GRAPH, SERVICES));

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
    return new AskUic(context, GRAPH, WORDS, new ServiceAsker(context));
  }
}
