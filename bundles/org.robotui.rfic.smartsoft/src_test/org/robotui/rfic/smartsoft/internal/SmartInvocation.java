package org.robotui.rfic.smartsoft.internal;

import java.time.Duration;
import java.util.Map;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.DynamicRecord;

/** A call that waits for twenty seconds. */
record SmartInvocation(ServiceRequest request, long deadlineNanos) implements CallHandler.Invocation<ServiceRequest> {
  static SmartInvocation of(String service, Map<String, Object> arguments) {
    return new SmartInvocation(new ServiceRequest(service, arguments),
        System.nanoTime() + Duration.ofSeconds(20).toNanos());
  }

  @Override
  public void progress(double fraction, String message) {
    // nobody looks
  }

  @Override
  public void feedback(DynamicRecord record) {
    // nobody looks
  }
}
