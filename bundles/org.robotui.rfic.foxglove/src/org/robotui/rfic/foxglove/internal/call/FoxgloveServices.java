package org.robotui.rfic.foxglove.internal.call;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.Service;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.PayloadSource;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.rfic.foxglove.internal.session.ServerSource;

/** Calls services of a server, in the encoding that it says, or the first that it takes. */
public final class FoxgloveServices implements CallHandler<ServiceRequest, ServiceReply> {
  private final FoxgloveClient client;
  private final PayloadFormats formats;

  /** How a service is asked and answers. */
  record Forms(PayloadSource source, PayloadFormat request, PayloadFormat response) {}

  /**
   * Creates a caller.
   *
   * @param client calls
   * @param formats knows how requests and responses are written
   */
  public FoxgloveServices(FoxgloveClient client, PayloadFormats formats) {
    this.client = client;
    this.formats = formats;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException, InterruptedException {
    Service service = service(invocation.request().service());
    Forms forms = forms(service);
    try {
      ByteBuffer request = forms.request().write(invocation.request().arguments());
      ByteBuffer reply =
          CallOutcomes.asked(() -> client.call(service, forms.source().encoding(), request, left(invocation)));
      return new ServiceReply(forms.response().read(reply));
    } catch (IllegalArgumentException e) {
      throw new CallException(service.name() + ": " + e.getMessage(), e);
    }
  }

  Service service(String name) throws CallException {
    return client.services().stream().filter(each -> each.name().equals(name)).findFirst()
        .orElseThrow(() -> new CallException("the server offers no service " + name));
  }

  Forms forms(Service service) {
    List<String> taken = client.info().map(info -> info.encodings()).orElse(List.of());
    String encoding = taken.isEmpty() ? "json" : taken.getFirst();
    PayloadSource request = ServerSource.of(service.request(), encoding, service.type() + "_Request");
    PayloadSource response = ServerSource.of(service.response(), request.encoding(), service.type() + "_Response");
    return new Forms(request, formats.of(request), formats.of(response));
  }

  private static Duration left(Invocation<ServiceRequest> invocation) {
    return Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
  }
}
