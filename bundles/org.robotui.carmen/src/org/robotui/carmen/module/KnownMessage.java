package org.robotui.carmen.module;

import org.robotui.carmen.message.IpcForm;

/**
 * A message that a central knows.
 *
 * @param id its number there; negative where modules send it to each other directly
 * @param form what it consists of
 * @param plain whether it is one of programs, whose data begin with their length
 */
public record KnownMessage(int id, IpcForm form, boolean plain) {}
