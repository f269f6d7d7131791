package org.robotui.xbot;

/**
 * What a joint shall do.
 *
 * @param joint index on the board
 * @param reference the numbers
 * @param mode what of them is meant, bits as in {@link StateFrame.Joint}; 0 is nothing
 */
public record JointReference(int joint, StateFrame.Reference reference, int mode) {}
