package org.robotui.rtps.internal.endpoint;

import org.robotui.rtps.EntityId;

/**
 * Another participant: its readers get one copy of what is new.
 *
 * @param destination where it is
 * @param reader the only one there, or {@link EntityId#UNKNOWN} for all
 * @param reliable whether one of them is
 */
record SendTarget(Destination destination, EntityId reader, boolean reliable) {}
