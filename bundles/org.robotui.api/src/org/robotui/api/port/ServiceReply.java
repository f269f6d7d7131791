package org.robotui.api.port;

import org.robotui.data.record.DynamicRecord;

/**
 * The reply of such a service.
 *
 * @param value its fields
 */
public record ServiceReply(DynamicRecord value) {}
