package org.robotui.bridge.internal.carry;

import org.robotui.api.port.Caller.Progress;
import org.robotui.bridge.internal.change.ServiceMapping;
import org.robotui.data.record.DynamicRecord;

/**
 * Tells feedback as it is configured. Feedback that has not the fields for it is left out: the goal goes on.
 *
 * @param told hears it
 * @param mapping what becomes of it
 */
record MappedProgress(Progress told, ServiceMapping mapping) implements Progress {
  @Override
  public void at(double fraction, String message) {
    told.at(fraction, message);
  }

  @Override
  public void feedback(DynamicRecord record) {
    DynamicRecord made;
    try {
      made = mapping.feedback(record);
    } catch (IllegalArgumentException e) {
      return;
    }
    told.feedback(made);
  }
}
