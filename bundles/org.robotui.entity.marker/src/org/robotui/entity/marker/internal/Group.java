package org.robotui.entity.marker.internal;

import org.robotui.api.port.SourceId;

/**
 * What solids have in common that are drawn at once.
 *
 * @param source who sent them
 * @param namespace of the markers, which can be hidden
 * @param spot where their frame is
 * @param form what they are
 * @param translucent whether something shines through
 */
record Group(SourceId source, String namespace, Spot spot, Form form, boolean translucent) {}
