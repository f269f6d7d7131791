package org.robotui.api.port;

import org.robotui.data.DynamicRecord;

/**
 * The reply of such a service.
 *
 * @param value its fields
 */
public record ServiceReply(DynamicRecord value) {}
