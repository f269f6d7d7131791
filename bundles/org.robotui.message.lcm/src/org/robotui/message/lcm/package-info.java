/** Messages of LCM as records of data, and how recordings of them are read. */
package org.robotui.message.lcm;
