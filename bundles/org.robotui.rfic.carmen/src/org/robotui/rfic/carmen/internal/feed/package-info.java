/** Messages as ports: what is made of them, who wants them, and what drives the robot. */
package org.robotui.rfic.carmen.internal.feed;
